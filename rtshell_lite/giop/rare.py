"""Values of types that robots hardly ever use:
fixed, long double, Principal (CORBA 3.0, 15.3.1.4, 15.3.2.8); the last is only read.
"""

import math
import re
import struct

from rtshell_lite.giop.descriptors import FIXED, LONGDOUBLE, kind
from rtshell_lite.giop.fixed_size import Fault

MOST_DIGITS = 31  # of a fixed


def reader(descriptor, order):
    """read(data, at) of a fixed (a text), a long double (a float, the nearest) or a Principal (octets)."""
    if kind(descriptor) == FIXED:
        return _fixed(*descriptor[1:])
    if kind(descriptor) == LONGDOUBLE:
        return _long_double(order)
    return _principal(order)


def writer(descriptor, order):
    """write(out, value) of a fixed (a text) or a long double (a float)."""
    if kind(descriptor) == FIXED:
        return _fixed_writer(*descriptor[1:])
    if kind(descriptor) == LONGDOUBLE:
        return _long_double_writer(order)
    raise Fault("a Principal is not sent")


def fixed(text, digits, scale):
    """The text of a fixed as the reader gives it: -1.50. Raises Fault for what is no number, or
    does not fit.
    """
    data = bytearray()
    _fixed_writer(digits, scale)(data, text)
    return _fixed(digits, scale)(data, 0)[0]


def _fixed_digits(text, digits, scale):
    """(sign, all digits as one text) of a fixed. Raises Fault for what is no number, or does not fit."""
    match = re.match(r"([-+]?)(\d+)(?:\.(\d*))?\Z", text, re.ASCII)
    if match is None:
        raise Fault("not a decimal number")
    sign = match.group(1)
    whole = match.group(2).lstrip("0")
    fraction = (match.group(3) or "").rstrip("0")
    if len(fraction) > scale or len(whole) > digits - scale:
        raise Fault(f"more than {digits} digits, {scale} of them after the point")
    return sign, whole + fraction.ljust(scale, "0")


def _fixed_writer(digits, scale):
    def write(out, text):
        sign, number = _fixed_digits(text, digits, scale)
        last = "d" if sign == "-" and number.strip("0") else "c"
        out += bytes.fromhex(number.rjust(digits // 2 * 2 + 1, "0") + last)

    return write


def _fixed(digits, scale):
    if not 0 < digits <= MOST_DIGITS or abs(scale) > MOST_DIGITS:
        raise Fault(f"a fixed of {digits} digits")
    size = digits // 2 + 1

    def read(data, offset):
        nibbles = bytes(data[offset : offset + size]).hex()  # the last is the sign
        number = nibbles[:-1]
        sign = {"c": "", "d": "-"}.get(nibbles[-1:])
        if len(nibbles) < 2 * size or sign is None or not number.isdigit():
            raise Fault("no fixed")
        if scale <= 0:
            return sign + str(int(number) * 10**-scale), offset + size
        number = number.zfill(scale + 1)
        return f"{sign}{int(number[:-scale])}.{number[-scale:]}", offset + size

    return read


def _long_double(order):
    pair = struct.Struct(order + "QQ")

    def read(data, offset):
        offset += -offset & 7
        halves = pair.unpack_from(data, offset)
        high, low = reversed(halves) if order == "<" else halves
        exponent = high >> 48 & 0x7FFF
        fraction = (high & (1 << 48) - 1) << 64 | low
        if exponent == 0x7FFF:
            value = math.nan if fraction else math.inf
        else:
            value = _scaled((1 << 112 if exponent else 0) | fraction, max(exponent, 1) - 16383 - 112)
        return (-value if high >> 63 else value), offset + 16

    return read


def _long_double_writer(order):
    pair = struct.Struct(order + "QQ")

    def write(out, value):
        halves = _quadruple(float(value))
        out += b"\0" * (-len(out) & 7) + pair.pack(*(reversed(halves) if order == "<" else halves))

    return write


def _quadruple(value):
    """The two halves of a float as a long double of 128 bits, sign and exponent in the first."""
    high = 1 << 63 if math.copysign(1, value) < 0 else 0
    if math.isnan(value):
        return high | 0x7FFF8 << 44, 0
    if math.isinf(value):
        return high | 0x7FFF << 48, 0
    if value == 0:
        return high, 0
    fraction, exponent = math.frexp(abs(value))  # 0.5 <= fraction < 1
    number = int(math.ldexp(fraction, 53)) - (1 << 52) << 60
    return high | (exponent + 16382) << 48 | number >> 64, number & (1 << 64) - 1


def _scaled(number, exponent):
    try:
        return math.ldexp(number, exponent)
    except OverflowError:
        return math.inf


def _principal(order):
    count = struct.Struct(order + "I")

    def read(data, offset):
        offset += -offset & 3
        end = offset + 4 + count.unpack_from(data, offset)[0]
        if end > len(data):
            raise Fault("octets without an end")
        return bytes(data[offset + 4 : end]), end

    return read
