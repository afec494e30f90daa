"""Linear axes from 0."""
import math

from study.page import SUPERSCRIPTS


def ticks_up_to(top):
    """0 and three to six multiples of 1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(top))
    step = next(m * power for m in (2, 1, 0.5, 0.2, 0.1) if m * power * 3 <= top)
    return [k * step for k in range(int(top / step * (1 + 1e-9)) + 1)]


def unit_of(top):
    """A power of ten to divide by, and how it is written before the unit; 1 for common numbers."""
    exponent = math.floor(math.log10(top))
    if -2 <= exponent <= 2:
        return 1.0, ""
    return 10.0**exponent, "10" + str(exponent).translate(SUPERSCRIPTS) + " "
