"""tramline batch: all fields of a large file, in chunks, resumable."""

import os

from qgis.core import (
    QgsProcessingException,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
)

from .base import TramlineAlgorithm
from .layers import given_layer
from .parameters import (
    FIELD,
    OUTPUT,
    add_field,
    add_id_field,
    add_machine,
    add_numbers,
    add_operation,
    add_run,
    advanced,
    chosen,
    further_options,
    machine_options,
)
from .results import PLAN_LAYERS, load_file, load_table

# Of more chunks the tables are loaded alone.
_CHUNKS_LOADED = 3
_SUMS = (
    ("FIELDS", "Fields planned", "planned"),
    ("REFUSED", "Fields refused", "refused"),
    ("AREA_M2", "Land, m²", "area_m2"),
    ("OVERLAP_M2", "Overlap, m²", "overlap_m2"),
    ("UNCOVERED_M2", "Uncovered land, m²", "uncovered_m2"),
    ("HOURS", "Hours", "hours"),
    ("EUROS", "Euros", "euros"),
)


class Batch(TramlineAlgorithm):
    command = "batch"
    title = "Plan a register of fields"
    help_text = (
        "Plans all fields of a large layer in chunks: memory does not grow with their number. A run that was cancelled or killed goes on "
        "where it stopped when it is started again with the same folder and 'Go on with what is there'.\n\n"
        "The folder gets a GeoPackage and a file of JSON lines for each chunk, and at the end tables of the fields and of those refused, which "
        "are loaded. The plans are loaded too where there are few chunks."
    )

    def declare(self):
        add_field(self, "Parcels")
        add_machine(self)
        add_operation(self)
        self.addParameter(
            QgsProcessingParameterString(
                "PRICES", "Plan tracks alone by these prices of overlap, uncovered land and a turn, such as 0.02,0.10,1", None, False, True
            )
        )
        self.addParameter(QgsProcessingParameterBoolean("RESUME", "Go on with what is there", False))
        self.addParameter(
            advanced(QgsProcessingParameterNumber(
                "CHUNK", "Fields of a chunk", QgsProcessingParameterNumber.Integer, 200, False, 1, 100000
            ))
        )
        add_id_field(self)
        add_run(self, seconds=False)
        self.addParameter(QgsProcessingParameterFolderDestination(OUTPUT, "Folder"))
        add_numbers(self, [(name, text) for name, text, _ in _SUMS])

    def work(self, parameters, context, feedback):
        machine = machine_options(self, parameters, context)
        named = self.parameterAsString(parameters, "ID_FIELD", context)
        resume = self.parameterAsBoolean(parameters, "RESUME", context)
        folder = self.parameterAsFileOutput(parameters, OUTPUT, context)
        if resume and named:
            raise QgsProcessingException(
                "A register whose fields are named by one of its columns is copied, so that it cannot be gone on with: leave the field with names out from the first run on."
            )
        parcels = given_layer(self, parameters, FIELD, context, feedback, named)
        if resume and parcels.file.startswith(self.folder):
            raise QgsProcessingException(
                "Only a layer that is a file of its own, without a filter, a selection and edits, can be gone on with: save it as a file first."
            )
        options = {
            "layer": parcels.layer, "crs": parcels.crs, **machine,
            "operation": chosen(self, parameters, "OPERATION", context),
            "prices": self.parameterAsString(parameters, "PRICES", context),
            "chunk": self.parameterAsInt(parameters, "CHUNK", context),
            "resume": resume,
            "output": folder,
        }
        sums = self.run_program(feedback, [parcels.file], options, further_options(self, parameters, context)).results[0]
        if sums["refused"]:
            feedback.pushWarning(f"{sums['refused']} fields were refused; {os.path.join(folder, 'refused.csv')} says why")
        group = f"Register: {os.path.basename(os.path.normpath(folder))}"
        chunks = sorted(name for name in os.listdir(os.path.join(folder, "chunks")) if name.endswith(".gpkg"))
        if len(chunks) <= _CHUNKS_LOADED:
            for name in chunks:
                load_file(os.path.join(folder, "chunks", name), PLAN_LAYERS, context, group)
        for table in ("fields", "refused"):
            load_table(os.path.join(folder, f"{table}.csv"), table, context, group)
        return {OUTPUT: folder, **{name: sums[key] for name, _, key in _SUMS if key in sums}}
