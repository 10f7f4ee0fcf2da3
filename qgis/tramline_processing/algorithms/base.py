"""What all algorithms have in common: the run of the program, its progress, and its end."""

import os
import tempfile

from processing.core.ProcessingConfig import ProcessingConfig
from qgis.core import QgsProcessingAlgorithm, QgsProcessingException

from ..program.find import ProgramMissing, find_program, version_of
from ..program.run import Cancelled, RunFailed, run
from ..program.words import BadWords, words_of

PROGRAM_SETTING = "TRAMLINE_PROGRAM"


class TramlineAlgorithm(QgsProcessingAlgorithm):
    """Algorithms say `command`, `title` and `help_text`, declare their parameters, and have a `work`."""

    command = ""
    title = ""
    help_text = ""

    def createInstance(self):
        return type(self)()

    def name(self):
        return self.command

    def displayName(self):
        return self.title

    def shortHelpString(self):
        return self.help_text

    def initAlgorithm(self, configuration=None):
        self.declare()

    def declare(self):
        raise NotImplementedError

    def work(self, parameters, context, feedback):
        """The results. `self.folder` is there for files that live as long as the run."""
        raise NotImplementedError

    def processAlgorithm(self, parameters, context, feedback):
        with tempfile.TemporaryDirectory(prefix="tramline-") as self.folder:
            return self.work(parameters, context, feedback)

    def run_program(self, feedback, files, options, more="", total=0, fine=(0, 3)):
        """Runs the command and gives what it printed. total: how many results there will be; 0: not known.

        Raises QgsProcessingException with one sentence. What single fields were refused for is told as warnings.
        """
        done_before, told = 0, ""

        def show(step):
            nonlocal told
            # Of many fields each has a progress of its own.
            share = (done_before + step.share) / total if total > 1 and done_before < total else step.share
            feedback.setProgress(100 * share)
            if step.what != told:
                told = step.what
                feedback.setProgressText(told)

        def count(number):
            nonlocal done_before
            done_before = number
            if total > 1:
                feedback.setProgress(100 * min(1.0, number / total))

        try:
            program = find_program(ProcessingConfig.getSetting(PROGRAM_SETTING) or "")
            version = version_of(program)
            words = words_of(self.command, files, {**options, "json": True}, more)
            feedback.pushInfo(version)
            feedback.pushCommandInfo(" ".join(_as_typed(word) for word in [program, *words]))
            done = run(program, words, show, count, feedback.isCanceled, fine)
        except (ProgramMissing, BadWords, RunFailed, Cancelled) as fault:
            raise QgsProcessingException(str(fault)) from None
        for message in done.messages:
            feedback.pushInfo(message)
        for one in done.results:
            if "error" in one:
                feedback.pushWarning(f"{one.get('field_id', 'a field')} refused: {one['error']}")
            for warning in one.get("warnings") or ():
                feedback.pushWarning(f"{one.get('field_id') or ''}: {warning}".removeprefix(": "))
        feedback.setProgress(100)
        return done

    def output_file(self, parameters, name, context, ending):
        """Where an output goes, "" where none is wanted; QGIS asks for a folder that is there."""
        file = self.parameterAsFileOutput(parameters, name, context)
        if not file:
            return ""
        if not file.lower().endswith(ending):
            file += ending[0] if isinstance(ending, tuple) else ending
        os.makedirs(os.path.dirname(os.path.abspath(file)), exist_ok=True)
        return file


def _as_typed(word):
    return f'"{word}"' if " " in word or not word else word
