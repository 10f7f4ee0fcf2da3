"""Values of parameters as the words of a command line."""

import shlex


class BadWords(ValueError):
    """Words that cannot be passed on; the message says why."""


def words_of(command, files, options, more=""):
    """["plan", "field.gpkg", "--width=6"], without the program itself.

    files: names that take no option. options: by their names without dashes; None, "" and False: left out, True: a flag, a list:
    given again for each. more: further options as they are typed in a shell. Throws BadWords.
    """
    out = [command, *(file for file in files if file)]
    for name, value in options.items():
        for one in value if isinstance(value, (list, tuple)) else [value]:
            if one is None or one is False or one == "":
                continue
            out.append(f"--{name}" if one is True else f"--{name}={_text(one)}")
    return out + _further(more or "", set(options))


def _text(value):
    """Numbers with all their digits, and without ".0"."""
    if isinstance(value, float):
        return repr(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
    return str(value)


def _further(typed, taken):
    try:
        words = shlex.split(typed)
    except ValueError as fault:
        raise BadWords(f"The further options '{typed}' cannot be read: {fault}.") from None
    if words and not words[0].startswith("-"):
        raise BadWords(f"Further options begin with an option such as --clearance, not with '{words[0]}'.")
    for word in words:
        name = word.split("=", 1)[0]
        if name in ("-o", "--json", "--quiet", "--help"):
            raise BadWords(f"Leave {name} out of the further options: the plugin gives it where it is needed.")
        if name.startswith("--") and name[2:] in taken:
            raise BadWords(f"Leave {name} out of the further options: there is a parameter for it.")
    return words
