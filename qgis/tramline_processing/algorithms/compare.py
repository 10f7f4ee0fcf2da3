"""tramline compare: the plans of a field that are worth a choice, or what it takes with other machines."""

import csv

from qgis.core import (
    QgsProcessingException,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterString,
)

from .base import TramlineAlgorithm
from .layers import given_layer, is_one_field
from .parameters import (
    GPKG_ENDING,
    FIELD,
    OUTPUT,
    PICTURE,
    PICTURE_ENDINGS,
    add_field,
    add_machine,
    add_numbers,
    add_obstacles,
    add_plan_outputs,
    add_run,
    advanced,
    further_options,
    machine_options,
    number_of,
    obstacle_options,
)
from .results import PLAN_LAYERS, load_file, load_table

_POINTS = ("given", "knee", "overlap", "uncovered", "turns")


class Compare(TramlineAlgorithm):
    command = "compare"
    title = "Compare plans"
    help_text = (
        "Finds the plans of one field that are worth a choice: of any two, each is better than the other in overlap, uncovered land, turns or "
        "stops. They are listed in a table; one of them can be written as a plan.\n\n"
        "With several working widths, what the whole job takes with each of them is compared instead: hours, litres and euros."
    )

    def declare(self):
        add_field(self, "Field")
        add_machine(self)
        self.addParameter(
            QgsProcessingParameterString("WIDTHS", "Compare these working widths, m, such as 6,12,24", None, False, True)
        )
        add_obstacles(self)
        add_run(self)
        self.addParameter(QgsProcessingParameterFileDestination("TABLE", "Table", "Tables (*.csv)"))
        self.addParameter(
            advanced(QgsProcessingParameterEnum("POINT", "The plan that is written", list(_POINTS), False, _POINTS[0], False, True))
        )
        add_plan_outputs(self, optional=True)
        add_numbers(self, [("PLANS", "Plans in the table")])

    def work(self, parameters, context, feedback):
        source = self.parameterAsSource(parameters, FIELD, context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, FIELD))
        widths = self.parameterAsString(parameters, "WIDTHS", context)
        machine = (
            {"machine": self.parameterAsFile(parameters, "MACHINE", context), "radius": number_of(self, parameters, "RADIUS", context)}
            if widths else machine_options(self, parameters, context)
        )
        if not is_one_field(source) and source.featureCount() != 1:
            raise QgsProcessingException(f"Choose one field: the layer has {source.featureCount()} features.")
        field = given_layer(self, parameters, FIELD, context, feedback)
        output = self.output_file(parameters, OUTPUT, context, GPKG_ENDING)
        table = self.output_file(parameters, "TABLE", context, ".csv")
        options = {
            "layer": field.layer, "crs": field.crs, **machine, "widths": widths,
            **obstacle_options(self, parameters, context, feedback),
            "point": self.parameterAsEnumString(parameters, "POINT", context) if output else None,
            "seconds": number_of(self, parameters, "SECONDS", context),
            "csv": table,
            "output": output,
            "picture": self.output_file(parameters, PICTURE, context, PICTURE_ENDINGS),
        }
        done = self.run_program(feedback, [field.file], options, further_options(self, parameters, context), fine=(0,))
        named = done.results[0].get("field_id") or "field"
        load_table(table, "compared plans", context, f"Comparison: {named}")
        with open(table, encoding="utf-8", newline="") as text:
            out = {"TABLE": table, "PLANS": sum(1 for _ in csv.DictReader(text))}
        for name, file in ((OUTPUT, output), (PICTURE, options["picture"])):
            if file:
                out[name] = file
        if output:
            load_file(output, PLAN_LAYERS, context, f"Comparison: {named}")
        return out
