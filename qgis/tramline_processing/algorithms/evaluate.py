"""tramline evaluate: what a drive covered, repeated and missed."""

from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
)

from .base import TramlineAlgorithm
from .layers import given_layer
from .parameters import (
    GPKG_ENDING,
    FIELD,
    GPKG_FILTER,
    OUTPUT,
    PICTURE,
    PICTURE_ENDINGS,
    add_field,
    add_layer_outputs,
    add_numbers,
    add_picture,
    add_run,
    further_options,
    number,
    number_of,
)
from .results import COVERAGE_LAYERS, load_file

_LAYERS = (
    ("COVERED", "Covered land", QgsProcessing.TypeVectorPolygon),
    ("REPEATED", "Land worked again", QgsProcessing.TypeVectorPolygon),
    ("MISSED", "Missed land", QgsProcessing.TypeVectorPolygon),
    ("GAPS", "Gaps that matter", QgsProcessing.TypeVectorPolygon),
)
_FIGURES = (
    ("COVERED_M2", "Covered land, m²", "covered_m2"),
    ("REPEATED_M2", "Land worked again, m²", "repeated_m2"),
    ("MISSED_M2", "Missed land, m²", "missed_m2"),
    ("OUTSIDE_M2", "Land covered outside the field, m²", "outside_m2"),
)


class Evaluate(TramlineAlgorithm):
    command = "evaluate"
    title = "Evaluate a drive"
    help_text = (
        "Finds exactly which land a recorded drive covered, worked again and missed, or what the drive of a plan would cover.\n\n"
        "Logs: CSV, NMEA 0183, GPX, ISOXML task data (a time log, a zip, or the folder), or a layer of points or worked polygons. Give the "
        "field, or the plan that was driven. Widths and work states of the log take precedence over the width given here. A log with several jobs "
        "needs --job under 'Further options'."
    )

    def declare(self):
        self.addParameter(QgsProcessingParameterFile("LOG", "Log of the drive", optional=True))
        self.addParameter(
            QgsProcessingParameterFeatureSource(
                "LOG_LAYER", "Log of the drive, as a layer", [QgsProcessing.TypeVectorPoint, QgsProcessing.TypeVectorPolygon], None, True
            )
        )
        add_field(self, "Field that was to be worked", optional=True)
        self.addParameter(QgsProcessingParameterFile("PLAN", "Plan that was driven", extension="gpkg", optional=True))
        self.addParameter(number("WIDTH", "Working width where the log has none, m", 0.01))
        add_run(self, seconds=False)
        self.addParameter(QgsProcessingParameterFileDestination(OUTPUT, "Coverage", GPKG_FILTER))
        add_picture(self)
        add_layer_outputs(self, _LAYERS)
        add_numbers(self, [(name, text) for name, text, _ in _FIGURES])

    def work(self, parameters, context, feedback):
        log = self.parameterAsFile(parameters, "LOG", context)
        layer = given_layer(self, parameters, "LOG_LAYER", context, feedback, only_layer=True)
        if log and layer:
            raise QgsProcessingException("Give the log as a file or as a layer, not both.")
        field = given_layer(self, parameters, FIELD, context, feedback)
        output = self.output_file(parameters, OUTPUT, context, GPKG_ENDING)
        options = {
            "field": field.file if field else None,
            "layer": field.layer if field else None,
            "crs": field.crs if field else None,
            "plan": self.parameterAsFile(parameters, "PLAN", context),
            "width": number_of(self, parameters, "WIDTH", context),
            "output": output,
            "picture": self.output_file(parameters, PICTURE, context, PICTURE_ENDINGS),
        }
        done = self.run_program(
            feedback, [layer.file if layer else log], options, further_options(self, parameters, context)
        )
        if len(done.results) != 1:
            raise QgsProcessingException(
                f"The log has {len(done.results)} jobs, each with files of its own beside '{output}'; choose one with --job under "
                "'Further options'."
            )
        found = done.results[0]
        layers = load_file(output, COVERAGE_LAYERS, context, f"Drive: {found.get('field_id') or 'no field'}")
        out = {OUTPUT: output}
        if options["picture"]:
            out[PICTURE] = options["picture"]
        out.update({name: layers[name.lower()] for name, _, _ in _LAYERS if name.lower() in layers})
        out.update({name: found[key] for name, _, key in _FIGURES if found.get(key) is not None})
        return out
