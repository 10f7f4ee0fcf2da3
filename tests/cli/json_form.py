"""One form for JSON that means the same: for goldens that people read, and that outlive noise."""

import json
import math

DIGITS = 9


def as_number(text):
    number = float(text)
    if not math.isfinite(number):
        raise ValueError(f"{text} is too large")
    return float(f"{number:.{DIGITS}g}")


def refuse(word):
    raise ValueError(f"{word} is not JSON")


def as_object(pairs):
    found = dict(pairs)
    if len(found) != len(pairs):
        raise ValueError("a key stands there twice")
    return found


def parsed(text):
    """The object or array that the text is from its first character to its last; a ValueError otherwise."""
    if text[:1] not in ("{", "[") or text[-1:] not in ("}", "]"):
        raise ValueError("neither object nor array")
    return json.loads(text, parse_float=as_number, parse_constant=refuse, object_pairs_hook=as_object)


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def laid_out(value, indent=""):
    inner = indent + "  "
    if isinstance(value, dict):
        items = [f"{laid_out(key)}: {laid_out(item, inner)}" for key, item in value.items()]
        brackets = "{}"
    elif isinstance(value, list) and not all(map(is_number, value)):
        items = [laid_out(item, inner) for item in value]
        brackets = "[]"
    else:
        return json.dumps(value, ensure_ascii=False)
    if not items:
        return brackets
    return brackets[0] + ",".join(f"\n{inner}{item}" for item in items) + f"\n{indent}{brackets[1]}"


def normalised(text):
    """The text, if it is JSON, with a key a line and numbers of nine digits; any other text as it is.

    A text of JSON is one document, or one document a line, and ends with a line feed. The order of keys
    stays, integers keep all their digits, and an array of numbers stays on one line.
    """
    if not text.endswith("\n"):
        return text
    body = text[:-1]
    for documents in ([body], body.split("\n")):
        try:
            return "".join(laid_out(parsed(document)) + "\n" for document in documents)
        except ValueError:
            continue
    return text
