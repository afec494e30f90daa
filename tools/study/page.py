"""Pages of docs/ whose text is written by hand and whose numbers are made by a command."""
from pathlib import Path

from study.film import InvalidInput

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def fill(path, part, text):
    """Puts text between <!-- part:begin --> and <!-- part:end -->, at the end of a page that lacks both."""
    path, begin, end = Path(path), f"<!-- {part}:begin -->", f"<!-- {part}:end -->"
    page = path.read_text(encoding="utf-8") if path.exists() else ""
    if begin not in page and end not in page:
        page += f"{begin}\n{end}\n"
    if page.count(begin) != 1 or page.count(end) != 1 or page.index(begin) > page.index(end):
        raise InvalidInput(f"{path}: needs one line `{begin}` and after it one line `{end}`")
    before, rest = page.split(begin)
    lines = text.strip("\n")  # the first one may be indented
    write(path, f"{before}{begin}\n{lines}\n{end}{rest.split(end)[1]}")


def write(path, text):
    """The file appears whole or not at all."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    whole = path.with_name(path.name + ".part")
    whole.write_text(text, encoding="utf-8")
    whole.replace(path)


def table(heads, rows):
    """In Markdown: the first column to the left, all others to the right."""
    lines = [heads, ["---"] + ["--:"] * (len(heads) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def power_of_ten(number):
    """10⁷, 2.5·10⁸; numbers up to 1000 as they are."""
    if number <= 1000:
        return f"{number:g}"
    mantissa, exponent = f"{number:.1e}".split("e")
    mantissa = mantissa.removesuffix(".0")
    power = "10" + str(int(exponent)).translate(SUPERSCRIPTS)
    return power if mantissa == "1" else f"{mantissa}·{power}"


def percent(fraction):
    """Two digits: 0.0713 is 7.1 %."""
    x = 100 * fraction
    if x == 0:
        return "0 %"
    return f"{x:.0f} %" if x >= 9.95 else f"{x:.1f} %" if x >= 0.995 else f"{x:#.2g} %"


def error_text(relative_mse, reference_error):
    """Relative RMSE; of an error below that of its reference only the bound is sure."""
    if relative_mse > reference_error**2:
        return percent(relative_mse**0.5)
    return f"< {percent(reference_error)}"
