"""Layers of QGIS as files that the program reads."""

import os

from qgis.core import (
    NULL,
    QgsFeatureRequest,
    QgsFeatureSink,
    QgsField,
    QgsFields,
    QgsProcessingException,
    QgsProcessingFeatureSourceDefinition,
    QgsProviderRegistry,
    QgsVectorFileWriter,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QVariant

_PLAIN = (QVariant.Int, QVariant.UInt, QVariant.LongLong, QVariant.ULongLong, QVariant.Double, QVariant.String, QVariant.Bool)


class GivenLayer:
    """A file, and which layer of it; `crs` is only named where the file itself has none or another."""

    def __init__(self, file, layer="", crs=""):
        self.file, self.layer, self.crs = file, layer, crs


def given_layer(algorithm, parameters, name, context, feedback, id_field="", only_layer=False):
    """The features of a parameter as a file; None where the parameter is not given.

    The file of the layer itself where the program can read it, so that its messages name the user's own file and features; else a
    copy. id_field: the attribute whose values are the ids of the fields. only_layer: the program takes the file without a layer
    and a CRS.
    """
    if parameters.get(name) is None:
        return None
    source = algorithm.parameterAsSource(parameters, name, context)
    if source is None:
        raise QgsProcessingException(algorithm.invalidSourceError(parameters, name))
    layer = algorithm.parameterAsVectorLayer(parameters, name, context)
    own = None if id_field else _own_file(layer, parameters[name])
    if own is not None and not (only_layer and (own.crs or len(layer.dataProvider().subLayers()) > 1)):
        return own
    file = os.path.join(algorithm.folder, f"{name.lower()}.gpkg")
    return _copy(source, file, _name_in_file(layer) or source.sourceName() or "fields", id_field, context, feedback)


def _own_file(layer, given):
    """None where not all of the file is meant, or where it is no file."""
    if isinstance(given, QgsProcessingFeatureSourceDefinition) and not _is_whole(given):
        return None
    if not isinstance(layer, QgsVectorLayer) or layer.providerType() != "ogr":
        return None
    if layer.subsetString() or layer.isModified():
        return None
    parts = QgsProviderRegistry.instance().decodeUri("ogr", layer.source())
    file = parts.get("path") or ""
    if not os.path.isfile(file) or parts.get("vsiPrefix"):
        return None
    crs = "" if layer.crs() == layer.dataProvider().crs() else _crs_text(layer.crs())
    return GivenLayer(file, _name_in_file(layer), crs)


def _name_in_file(layer):
    """What the program and its plan files call the layer; "" where it is in no file."""
    if not isinstance(layer, QgsVectorLayer) or layer.providerType() != "ogr":
        return ""
    name = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName")
    if name:
        return name
    first = layer.dataProvider().subLayers()[:1]
    return first[0].split(layer.dataProvider().sublayerSeparator())[1] if first else ""


def _is_whole(definition):
    filtered = getattr(definition, "filterExpression", "")
    return not definition.selectedFeaturesOnly and getattr(definition, "featureLimit", -1) < 0 and not filtered


def _crs_text(crs):
    return "none" if not crs.isValid() else crs.authid() or crs.toWkt()


def _copy(source, file, name, id_field, context, feedback):
    """With the numbers that the features have, as far as a GeoPackage can have them."""
    # The program finds and repairs faults itself.
    request = QgsFeatureRequest().setInvalidGeometryCheck(QgsFeatureRequest.GeometryNoCheck)
    features = source.getFeatures(request)
    names = [field.name().lower() for field in source.fields()]
    kept = [i for i, field in enumerate(source.fields()) if field.type() in _PLAIN and names[i] not in ("fid", "id")]
    id_at = source.fields().lookupField(id_field or "id")
    fields = QgsFields()
    fields.append(QgsField("fid", QVariant.LongLong))
    if id_at >= 0:
        fields.append(QgsField("id", QVariant.String))
    for i in kept:
        fields.append(source.fields().at(i))
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = "GPKG"
    options.layerName = name
    writer = QgsVectorFileWriter.create(
        file, fields, source.wkbType(), source.sourceCrs(), context.transformContext(), options
    )
    if writer.hasError() != QgsVectorFileWriter.NoError:
        raise QgsProcessingException(f"The layer could not be copied: {writer.errorMessage()}")
    for number, feature in enumerate(features, 1):
        if feedback.isCanceled():
            raise QgsProcessingException("The run was cancelled.")
        own = feature.attributes()
        row = [feature.id() if feature.id() >= 0 else number]
        if id_at >= 0:
            row.append(None if own[id_at] in (None, NULL) else str(own[id_at]))
        feature.setFields(fields)
        feature.setAttributes(row + [own[i] for i in kept])
        if not writer.addFeature(feature, QgsFeatureSink.FastInsert):
            raise QgsProcessingException(f"Feature {own} could not be copied: {writer.errorMessage()}")
    del writer
    crs = "" if source.sourceCrs().isValid() else "none"
    return GivenLayer(file, name, crs)


def is_one_field(source):
    """Whether the program will see exactly one field: one feature that needs no repair and has one part."""
    if source.featureCount() != 1:
        return False
    request = QgsFeatureRequest().setInvalidGeometryCheck(QgsFeatureRequest.GeometryNoCheck)
    for feature in source.getFeatures(request):
        shape = feature.geometry()
        return not shape.isNull() and shape.constGet().partCount() == 1 and shape.isGeosValid()
    return False
