"""What QGIS loads: a plugin that has a provider for Processing, and nothing else."""

from qgis.core import QgsApplication

from .provider import Provider


class Plugin:
    def __init__(self, iface):
        self._provider = None

    def initProcessing(self):
        """Called alone by qgis_process, where there are no windows."""
        self._provider = Provider()
        QgsApplication.processingRegistry().addProvider(self._provider)

    def initGui(self):
        self.initProcessing()

    def unload(self):
        if self._provider is not None:
            QgsApplication.processingRegistry().removeProvider(self._provider)
            self._provider = None
