"""Opens a page in headless Chromium, narrow and wide: no message on the console, nothing wider than the window, no text of a plot cut off
or over another.

    check_page.py CHROMIUM PAGE.html"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

WIDTHS = (390, 1400)  # a phone's, a desk's
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--enable-logging=stderr", "--hide-scrollbars"]
CHROMIUM_SECONDS = 120

# Around the page, in a frame of the width that is asked for: a window of its own has a least width. Shows what the page finds.
FRAME = """<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,"><body>
<script>addEventListener('message', e => {
  const result = document.createElement('pre');
  result.id = 'findings';
  result.textContent = e.data;
  document.body.append(result);
});</script>
<iframe src="page.html" width="WIDTH" height="1000" style="border:0"></iframe></body>"""

# Added to a copy of the page: tells the frame what it finds.
CHECK = """
<script>
const found = {width: innerWidth, plots: 0, texts: 0, wrong: []};
const slack = 0.6;  // of a pixel: rounding of boxes
const say = (what, element) => found.wrong.push(what + ': ' + element.textContent.trim().slice(0, 60));
document.querySelectorAll('details').forEach(d => d.open = true);
if (document.documentElement.scrollWidth > innerWidth) found.wrong.push('the page is ' + document.documentElement.scrollWidth + ' wide');
for (const svg of document.querySelectorAll('svg.plot')) {
  found.plots++;
  const frame = svg.getBoundingClientRect(), boxes = [];
  if (frame.width < 300) say('a plot is only ' + frame.width + ' wide', svg);
  for (const text of svg.querySelectorAll(':scope > text')) {
    const b = text.getBoundingClientRect();
    found.texts++;
    if (b.left < frame.left - slack || b.right > frame.right + slack || b.top < frame.top - slack || b.bottom > frame.bottom + slack)
      say('cut off', text);
    if (boxes.some(o => o.left < b.right - slack && b.left < o.right - slack && o.top < b.bottom - slack && b.top < o.bottom - slack))
      say('over another text', text);
    boxes.push(b);
  }
}
for (const element of document.querySelectorAll('h1,h2,h3,p,li,figcaption,summary')) {
  const b = element.getBoundingClientRect();
  if (b.left < 0 || b.right > innerWidth + slack || element.scrollWidth > element.clientWidth + 1) say('beside the window', element);
}
for (const wide of document.querySelectorAll('.wide'))
  if (!wide.closest('details') && wide.scrollWidth > wide.clientWidth + 1)
    say('a table is ' + wide.scrollWidth + ' wide of ' + wide.clientWidth, wide);
parent.postMessage(JSON.stringify(found), '*');
</script>
"""


def findings(chromium, page, width):
    """(what the check found in a window of this width, what the console said)"""
    with tempfile.TemporaryDirectory() as folder:
        frame = Path(folder) / "frame.html"
        frame.write_text(FRAME.replace("WIDTH", str(width)), encoding="utf-8")
        copy = frame.with_name("page.html")
        copy.write_text(page.read_text(encoding="utf-8").replace("</body>", CHECK + "</body>"), encoding="utf-8")
        command = [chromium, *FLAGS, f"--user-data-dir={folder}/user", "--window-size=1600,1200", "--virtual-time-budget=10000", "--dump-dom",
                   frame.as_uri()]
        done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=CHROMIUM_SECONDS, check=False)
    report = re.search(r'<pre id="findings">(.*?)</pre>', done.stdout, re.DOTALL)
    if report is None:
        sys.exit(f"no findings at a width of {width}: {done.stderr[-2000:]}")
    text = report.group(1).replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
    return json.loads(text), [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def main():
    chromium, page = sys.argv[1], Path(sys.argv[2]).resolve()
    failed = False
    for width in WIDTHS:
        found, console = findings(chromium, page, width)
        print(f"width {found['width']}: {found['plots']} plots, {found['texts']} texts in them")
        wrong = found["wrong"] + console
        if found["width"] != width or found["plots"] == 0 or found["texts"] == 0:
            wrong.append(f"asked for a width of {width} and a page with plots")
        for line in wrong[:40]:
            print(f"  {line}")
        failed = failed or bool(wrong)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
