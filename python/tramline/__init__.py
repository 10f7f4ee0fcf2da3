"""Plans every pass a machine makes over a field, and proves what was worked.

Lengths are metres, areas square metres, times seconds, angles degrees, money euros.
docs/python.md of the project has examples.
"""

from ._api import check, compare, evaluate, plan, plan_fields, price, read
from ._core import InputError, RunError
from ._core import version as __version__
from ._results import Comparison, Evaluation, Plan, Verdict

__all__ = [
    "Comparison",
    "Evaluation",
    "InputError",
    "Plan",
    "RunError",
    "Verdict",
    "__version__",
    "check",
    "compare",
    "evaluate",
    "plan",
    "plan_fields",
    "price",
    "read",
]
