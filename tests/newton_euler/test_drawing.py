"""Drawing: the projection is to scale and right-handed, labels keep clear, the far is covered by the near, and mistakes are told."""

import io
import math
import subprocess
import sys

import numpy as np
import pytest

from newton_euler import Frame, FrameError, rad
from newton_euler.drawing import ARROW, KINDS, LOOKS, Sketch, _cut, _far_to_near, _Ink, _plane_view, _space_view
