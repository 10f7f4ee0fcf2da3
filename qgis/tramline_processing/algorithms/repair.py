"""tramline repair: passes over the land that a drive has missed."""

from qgis.core import QgsProcessing, QgsProcessingParameterFile

from .base import TramlineAlgorithm
from .parameters import (
    GPKG_ENDING,
    OUTPUT,
    PICTURE,
    PICTURE_ENDINGS,
    add_layer_outputs,
    add_machine,
    add_numbers,
    add_plan_outputs,
    add_run,
    further_options,
    machine_options,
    number,
    number_of,
)
from .results import PLAN_LAYERS, load_file

_SUMS = (
    ("GAPS", "Gaps", "gaps"),
    ("GAPS_TAKEN", "Gaps worked by the plan", "gaps_taken"),
    ("MISSED_BEFORE_M2", "Missed land, m²", "missed_before_m2"),
    ("MISSED_AFTER_M2", "Missed land that remains, m²", "missed_after_m2"),
)


class Repair(TramlineAlgorithm):
    command = "repair"
    title = "Repair what was missed"
    help_text = (
        "Plans passes over the land that a drive has missed. Takes the coverage file that 'Evaluate a drive' has written with a field or a "
        "plan. A pass that costs more than it wins back is left out; the log lists the gaps that remain, with the reason."
    )

    def declare(self):
        self.addParameter(QgsProcessingParameterFile("COVERAGE", "Coverage", extension="gpkg"))
        add_machine(self)
        self.addParameter(number("MIN_AREA", "Leave gaps smaller than this, m²", default=1.0))
        add_run(self)
        add_plan_outputs(self)
        add_layer_outputs(self, [("TRACKS", "Tracks", QgsProcessing.TypeVectorLine)])
        add_numbers(self, [(name, text) for name, text, _ in _SUMS])

    def work(self, parameters, context, feedback):
        coverage = self.parameterAsFile(parameters, "COVERAGE", context)
        machine = machine_options(self, parameters, context)
        output = self.output_file(parameters, OUTPUT, context, GPKG_ENDING)
        options = {
            **machine,
            "min-area": number_of(self, parameters, "MIN_AREA", context),
            "seconds": number_of(self, parameters, "SECONDS", context),
            "output": output,
            "picture": self.output_file(parameters, PICTURE, context, PICTURE_ENDINGS),
        }
        done = self.run_program(feedback, [coverage], options, further_options(self, parameters, context))
        for part in done.results:
            for kind in ("gaps_ignored", "gaps_unreachable", "gaps_not_worth"):
                for gap in part.get(kind, ()):
                    feedback.pushInfo(f"gap {gap['number']} of {gap['area_m2']:.1f} m² is left: {gap['why']}")
        out = {name: sum(part.get(key) or 0 for part in done.results) for name, _, key in _SUMS}
        out[OUTPUT] = output
        if options["picture"]:
            out[PICTURE] = options["picture"]
        layers = load_file(output, PLAN_LAYERS, context, "Repair")
        if "tracks" in layers:
            out["TRACKS"] = layers["tracks"]
        return out
