"""What a page of the report must have: every section, measured in this run; and the page and the table of docs, made by the same command.

    check_contents.py PAGE.html TABLE RESULTS DOCS

PAGE.html is of a quick run, TABLE what that printed, RESULTS its folder, DOCS the folder with report.md and report/report.html."""
import csv
import html
import re
import sys
from pathlib import Path

SECTIONS = ["Time against error", "Energy over time", "Sensitivities", "Cost against the number of links", "Lyapunov exponents",
            "How it was measured"]
QUICK_SIZES = {"1", "2"}  # of bench/run --quick
NUMBER = re.compile(r"(\d+(\.\d+)?)?")

failures = []


def expect(good, text):
    if not good:
        failures.append(text)


def plain(text):
    return html.unescape(re.sub(r"<[^>]*>", "", text)).strip()


def headings(page, level):
    return [plain(text) for text in re.findall(rf"<h{level}>(.*?)</h{level}>", page)]


def section(page, name):
    return next((part for part in re.split(r"(?=<h2>)", page) if headings(part, 2) == [name]), "")


def figures(page):
    """{title: markup}"""
    return {plain(re.search(r"<figcaption>(.*?)</figcaption>", part).group(1)): part for part in re.findall(r"<figure>.*?</figure>", page, re.S)}


def check_page(page, what):
    found = headings(page, 2)
    expect(found == SECTIONS, f"{what}: sections {found}")
    lyapunov = figures(section(page, "Lyapunov exponents"))
    for links in range(1, 7):
        figure = lyapunov.get(f"{links} link{'s' if links > 1 else ''}", "")
        expect("<th>from</th><th>to</th>" in figure, f"{what}: no convergence of {links} links with intervals")
        for i in range(links):
            expect(f"λ{'₁₂₃₄₅₆'[i]}" in figure, f"{what}: {links} links without exponent {i + 1}")
    one = lyapunov.get("One link: the maximal exponent tends to zero", "")
    expect("ln(1.64 t)/t" in one, f"{what}: nothing shows that one link's exponent tends to zero")
    sensitivities = section(page, "Sensitivities")
    expect(sensitivities.count("<figure>") == 8, f"{what}: {sensitivities.count('<figure>')} figures of sensitivities")
    expect(section(page, "Cost against the number of links").count("<figure>") == 4, f"{what}: figures of cost are missing")


def check_cost(page, rows):
    """The figures have the fastest build of each contender."""
    cost = section(page, "Cost against the number of links")
    for need, title in (("F", "Accelerations, independent states"), ("J", "Accelerations and linearisation, independent states")):
        figure = figures(cost).get(title, "")
        for contender in ("adjoint", "hand"):
            for size in QUICK_SIZES:
                times = [float(row["min_ns"]) for row in rows if (row["contender"], row["need"], row["N"], row["way"]) == (contender, need, size, "throughput")]
                expect(f"<td>{min(times):.5g}</td>" in figure, f"{title}: not the {min(times)} ns of {contender} at N={size}")


def methods(page):
    """The names in the keys of the figures of this library's methods, of equal steps or not."""
    names = set()
    for part in re.findall(r"<figure><figcaption>Methods of this library.*?</figure>", page, re.S):
        key = re.search(r'<ul class="key">(.*?)</ul>', part, re.S).group(1)
        names |= {plain(item).removesuffix(", equal steps") for item in re.findall(r"<li.*?</li>", key, re.S)}
    return names


def rows_of_text(text):
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("|")]


def rows_of_page(page):
    table = section(page, "Time against error").split("</table>")[0]
    return [[plain(cell) for cell in re.findall(r"<t[hd].*?>(.*?)</t[hd]>", row)] for row in re.findall(r"<tr>.*?</tr>", table, re.S)]


def check_table(table, form, page):
    """The table of docs/report.md has the form of what a run prints, and the numbers of the page."""
    expect([row[0] for row in table] == [row[0] for row in form], f"docs/report.md: rows {[row[0] for row in table]}")
    expect(table[:1] == form[:1], f"docs/report.md: head {table[:1]}, a run prints {form[:1]}")
    for row in table[2:]:
        expect(len(row) == len(form[0]) and all(NUMBER.fullmatch(cell) for cell in row[1:-1]), f"docs/report.md: row {row}")
    expect([row[:-1] for row in table if not row[0].startswith("---")] == rows_of_page(page), "docs/report.md: not the table of report.html")


def main():
    page, printed = (Path(path).read_text(encoding="utf-8") for path in sys.argv[1:3])
    results, docs = map(Path, sys.argv[3:5])
    kept = (docs / "report" / "report.html").read_text(encoding="utf-8")
    with open(results / "cost.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    expect({row["N"] for row in rows} == QUICK_SIZES and {row["model"] for row in rows} == {"pendulum"},
           f"cost is of {sorted({(row['model'], row['N']) for row in rows})}: not of this run")
    check_page(page, "the quick page")
    check_cost(page, rows)
    check_page(kept, "docs/report/report.html")
    for rival in ("by hand", "CasADi", "heyoka", "Pinocchio"):
        expect(section(kept, "Cost against the number of links").count(f"</svg>{rival}</li>") == 4, f"docs/report/report.html: cost without {rival}")
    known = methods(page)
    if "cvode_adams" in known:  # a build with SUNDIALS has all
        expect(methods(kept) <= known, f"docs/report/report.html: methods that are no more: {sorted(methods(kept) - known)}")
    check_table(rows_of_text((docs / "report.md").read_text(encoding="utf-8")), rows_of_text(printed), kept)
    for line in failures:
        print(line)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
