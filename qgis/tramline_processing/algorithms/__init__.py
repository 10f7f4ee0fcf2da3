"""An algorithm for each command of the program that QGIS calls."""

from .batch import Batch
from .check import Check
from .compare import Compare
from .evaluate import Evaluate
from .map import Map
from .plan import Plan
from .repair import Repair

ALGORITHMS = (Plan, Map, Evaluate, Repair, Compare, Batch, Check)
