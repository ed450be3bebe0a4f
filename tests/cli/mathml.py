"""Presentation MathML as the pages print it, worked out with numbers: value and error of every side of a formula."""
import math
import re
import xml.etree.ElementTree

GREEK = dict(zip("αβγδεζηθικλμνξοπρστυφχψωΓΔΘΛΞΠΣΦΨΩ", (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma tau upsilon phi chi psi omega "
    "Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega").split()))
FUNCTIONS = {"sin": (math.sin, lambda x: abs(math.cos(x))), "cos": (math.cos, lambda x: abs(math.sin(x))),
             "tan": (math.tan, lambda x: 1 + math.tan(x) ** 2), "sqrt": (math.sqrt, lambda x: 0.5 / math.sqrt(x) if x > 0 else 0)}
ROUNDING = 1e-13  # of the terms of a sum


class Unknown(Exception):
    """What has no value here: a vector's name, words, a symbol that nothing has told yet."""


class Number:
    """A value and how far it may be off: roundings of what it is made from."""

    def __init__(self, value, error=0.0):
        self.value, self.error = value, error

    def __add__(self, other):
        return Number(self.value + other.value, self.error + other.error + ROUNDING * (abs(self.value) + abs(other.value)))

    def __neg__(self):
        return Number(-self.value, self.error)

    def __mul__(self, other):
        return Number(self.value * other.value, abs(self.value) * other.error + abs(other.value) * self.error +
                      self.error * other.error)

    def over(self, other):
        if abs(other.value) <= 10 * other.error:
            raise Unknown("a quotient by what may be nothing")
        value = self.value / other.value
        return Number(value, (self.error + abs(value) * other.error) / abs(other.value))

    def power(self, exponent):
        if exponent < 0:
            return Number(1).over(self.power(-exponent))
        if exponent == 0.5:
            return self.of("sqrt")
        value = self.value ** exponent
        return Number(value, abs(exponent * self.value ** (exponent - 1)) * self.error if exponent >= 1 else 0)

    def of(self, function):
        value, slope = FUNCTIONS[function]
        return Number(value(self.value), slope(self.value) * self.error)


def name_of(element):
    """`theta4` of a letter with its index, dots as primes; None where it is no name."""
    if element.tag == "mi" and "style" not in element.attrib:
        return "".join(GREEK.get(letter, letter) for letter in element.text or "")
    parts = list(element)
    if element.tag == "mrow" and len(parts) == 1:
        return name_of(parts[0])
    if element.tag in ("msub", "mover") and len(parts) == 2:
        base = name_of(parts[0])
        rest = "".join(parts[1].itertext())
        if base is None:
            return None
        if element.tag == "mover":
            return base + {"˙": "'", "¨": "''"}[rest]
        bare = base.rstrip("'")  # the index belongs to the letter below the dots
        return bare + "".join(GREEK.get(c, c) for c in rest) + base[len(bare):]
    return None


def tokens_of(element, out):
    name = name_of(element) if element.tag in ("mi", "msub", "mover") else None
    parts = list(element)
    if name is not None:
        out.append(("function", name) if name in FUNCTIONS else ("name", name.replace("_", "")))
    elif element.tag == "mn":
        out.append(("number", float(element.text)))
    elif element.tag == "mo":
        out.append(("number", 0.0) if element.text == "0" else ("sign", {"−": "-", "\u2062": "*", "\u2061": ""}.get(element.text, element.text)))
    elif element.tag == "mtext":
        out.append(("words", element.text))
    elif element.tag == "mfrac":
        out += [("sign", "("), ("sign", "(")] + tokens_of(parts[0], []) + [("sign", ")"), ("sign", "/"), ("sign", "(")]
        out += tokens_of(parts[1], []) + [("sign", ")"), ("sign", ")")]
    elif element.tag == "msqrt":
        out += [("function", "sqrt"), ("sign", "(")]
        for part in parts:
            tokens_of(part, out)
        out.append(("sign", ")"))
    elif element.tag == "msup" and "style" not in next(iter(parts[0].iter("mi")), parts[0]).attrib:
        base = tokens_of(parts[0], [])
        if base and base[0][0] == "function":
            out += base + [("sign", "^")] + tokens_of(parts[1], [])
        else:
            out += [("sign", "(")] + base + [("sign", ")"), ("sign", "^"), ("sign", "(")] + tokens_of(parts[1], []) + [("sign", ")")]
    elif element.tag == "mtable":
        out.append(("matrix", [[tokens_of(cell, []) for cell in row] for row in parts]))
    elif element.tag in ("mrow", "math", "mtd"):
        for part in parts:
            tokens_of(part, out)
    else:
        out.append(("words", element.tag))
    return out


class Reader:
    """A sum of products, numbers for names. `value` raises Unknown."""

    def __init__(self, tokens, symbols):
        self.tokens, self.symbols, self.at = [t for t in tokens if t != ("sign", "")], symbols, 0

    def value(self):
        result = self.sum()
        if self.at < len(self.tokens):
            raise Unknown(self.tokens[self.at])
        return result

    def next_is(self, *signs):
        return self.at < len(self.tokens) and self.tokens[self.at][0] == "sign" and self.tokens[self.at][1] in signs

    def sum(self):
        result = Number(0)
        negative = False
        while self.next_is("+", "-"):
            negative ^= self.tokens[self.at][1] == "-"
            self.at += 1
        result = -self.product() if negative else self.product()
        while self.next_is("+", "-"):
            negative = self.tokens[self.at][1] == "-"
            self.at += 1
            result = result + (-self.product() if negative else self.product())
        return result

    def product(self):
        result = self.factor()
        while self.at < len(self.tokens):
            if self.next_is("*"):
                self.at += 1
                result = result * self.factor()
            elif self.next_is("/"):
                self.at += 1
                result = result.over(self.factor())
            elif self.next_is("(") or self.tokens[self.at][0] in ("name", "number", "function"):
                result = result * self.factor()
            else:
                break
        return result

    def factor(self):
        result = self.atom()
        if self.next_is("^"):
            self.at += 1
            result = result.power(self.exponent())
        return result

    def exponent(self):
        return self.atom().value

    def atom(self):
        if self.at >= len(self.tokens):
            raise Unknown("nothing")
        kind, what = self.tokens[self.at]
        self.at += 1
        if kind == "number":
            return Number(what)
        if kind == "name":
            if self.symbols.get(what) is None:
                raise Unknown(what)
            return self.symbols[what]
        if kind == "function":
            power = 1
            if self.next_is("^"):
                self.at += 1
                power = self.exponent()
            argument = self.atom()
            return argument.of(what).power(power)
        if (kind, what) == ("sign", "("):
            result = self.sum()
            if not self.next_is(")"):
                raise Unknown("a bracket left open")
            self.at += 1
            return result
        if (kind, what) == ("sign", "-"):
            return -self.atom()
        if kind == "words":
            amount = re.fullmatch(r"(-?[\d.]+(?:e[-+]?\d+)?) (kg(?:\*m\^2)?|m|N|s)", what)
            if amount:
                return Number(float(amount.group(1)), 1e-6 * abs(float(amount.group(1))))
        raise Unknown(what)


def sides_of(math_element):
    """The tokens between the signs of equality."""
    sides = [[]]
    for token in tokens_of(math_element, []):
        if token == ("sign", "="):
            sides.append([])
        else:
            sides[-1].append(token)
    return sides


def only_matrix(side):
    inner = [token for token in side if token[0] != "sign"]
    signs = [what for kind, what in side if kind == "sign"]
    return inner[0][1] if len(inner) == 1 and inner[0][0] == "matrix" and signs == ["[", "]"] else None


def formula(text):
    return sides_of(xml.etree.ElementTree.fromstring(text.replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "")))
