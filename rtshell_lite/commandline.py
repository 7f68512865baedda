"""How a command line is read: options anywhere, numbers below zero, no abbreviations, the same on every Python."""
import argparse
import re

from rtshell_lite import errors, text


class Parser(argparse.ArgumentParser):
    """argparse with options anywhere, numbers below zero as arguments, no abbreviations, and our errors."""

    def error(self, message):
        raise errors.Usage(message.replace(": -- ", ": "))

    def parse_args(self, argv):  # type: ignore[override]
        options, words = self._sorted(argv)
        return super().parse_args(options + ["--"] + words if words else options)

    def unfinished(self, words):
        """What the first words of a command line leave open, for completion.

        Returns the words that are no options, the option whose value comes next (None), and whether `--` ended the options.
        Raises Usage for an unknown option.
        """
        others, rest = [], list(words)
        while rest:
            word = rest.pop(0)
            if word == "--":
                return others + rest, None, True
            if not self._is_option(word):
                others.append(word)
                continue
            last = not rest
            action = self._option_string_actions.get(self._option(word, rest)[-1])  # None when a value is glued to it
            if last and action and action.nargs != 0:
                return others, action, False
        return others, None, False

    def _sorted(self, argv):
        """Separate options with their values from the other words; argparse itself cannot mix them on all Pythons."""
        options, words, rest = [], [], list(argv)
        while rest:
            word = rest.pop(0)
            if word == "--":
                words += rest
                break
            if self._is_option(word):
                options += self._option(word, rest)
            else:
                words.append(word)
        return options, words

    def _is_option(self, word):
        if re.match(r"-\.?[0-9]", word):  # -5 is a number, -0 and -0R are options where there is a -0
            return word[:2] in self._option_string_actions and not re.search("[0-9.]", word[2:])
        return word.startswith("-") and word != "-"

    def _option(self, word, rest):
        """One option as argparse reads it on every Python: clusters (-lR) apart, with its value, which may come from `rest`."""
        if word.startswith("--"):
            name, equals, _ = word.partition("=")
            action = self._known(name, word)
            return [word] if equals else self._with_value(word, action, rest, "=")
        action = self._known(word[:2], word)
        if len(word) == 2:
            return self._with_value(word, action, rest, "")
        if action.nargs == 0:
            return [word[:2]] + self._option("-" + word[2:], rest)
        return [word]

    def _known(self, name, word):
        # not left to argparse: it takes abbreviations, and its way to forbid them breaks -n5 before Python 3.8
        if name not in self._option_string_actions:
            self.error("unrecognized arguments: " + text.printable(word))
        return self._option_string_actions[name]

    @staticmethod
    def _with_value(word, action, rest, glue):
        if not rest or action.nargs == 0:
            return [word]
        # --wait PATH, --shell PATH: a word that cannot be the option's value is not taken for it
        if action.nargs == "?":
            fits = rest[0] in action.choices if action.choices else re.match(r"\.?[0-9]+\.?[0-9]*$", rest[0])
            if not fits:
                return [word]
        value = rest.pop(0)
        return [word + glue + value] if value.startswith("-") else [word, value]  # argparse would take -n -x for two options
