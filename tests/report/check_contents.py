"""What a page of the report must have: every section, measured in this run.

    check_contents.py PAGE.html RESULTS

PAGE.html is of a quick run, RESULTS its folder."""
import csv
import html
import re
import sys
from pathlib import Path

SECTIONS = ["Time against error", "Energy over time", "Sensitivities", "Cost against the number of links", "Lyapunov exponents",
            "How it was measured"]
QUICK_SIZES = {"1", "2"}  # of bench/run --quick

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


def main():
    page, results = Path(sys.argv[1]).read_text(encoding="utf-8"), Path(sys.argv[2])
    with open(results / "cost.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    expect({row["N"] for row in rows} == QUICK_SIZES and {row["model"] for row in rows} == {"pendulum"},
           f"cost is of {sorted({(row['model'], row['N']) for row in rows})}: not of this run")
    check_page(page, "the quick page")
    for line in failures:
        print(line)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
