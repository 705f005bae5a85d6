# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cloud whose points change in time beside one that does not: each step's picture is that of still
clouds, forth and back, and what does not change is not made anew."""
import numpy as np
from paraview.simple import Delete, GetAnimationScene, Hide

import splat_scenes as scenes
from splat_scenes import at_least, picture

STEPS = (0.0, 1.0, 2.0)
MOVING = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline
time = self.GetOutputInformation(0).Get(pipeline.UPDATE_TIME_STEP())
fill(self.GetOutput(), RADII(time) * sphere(1.0, COUNT) + [0, -0.5, 0], 0)
"""
TIMES = f"""
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline
about = self.GetOutputInformation(0)
about.Set(pipeline.TIME_STEPS(), {STEPS}, {len(STEPS)})
about.Set(pipeline.TIME_RANGE(), ({STEPS[0]}, {STEPS[-1]}), 2)
"""
RADII = "(lambda time: 0.3 + 0.2 * time)"


def rendered(shown):
    """What the representation draws."""
    return shown.GetClientSideObject().GetRenderedDataObject(0)


view = scenes.new_view()
constant = scenes.cloud("fill(self.GetOutput(), 0.4 * sphere(1.0, COUNT) + [0, 0.9, 0], 0)", count=8000)
still = scenes.show(constant, view)
references = []
for time in STEPS:
    body = MOVING[MOVING.index("fill") :].replace("time", str(time)).replace("RADII", RADII)
    one = scenes.cloud(body, count=8000)
    scenes.show(one, view)
    references.append(picture(view))
    Hide(one, view)
    Delete(one)
worst = np.fmax(scenes.psnr(references[0], references[1]), scenes.psnr(references[1], references[2]))
assert worst < 30, "the steps look alike"

moving = scenes.cloud(MOVING.replace("RADII", RADII), count=8000)
moving.ScriptRequestInformation = TIMES
moving.UpdatePipelineInformation()
moves = scenes.show(moving, view)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
made = None
for time in (*STEPS, *STEPS[::-1], *STEPS):
    scene.AnimationTime = time
    of_step = picture(view)
    at_least(scenes.psnr(references[int(time)], of_step), 50, f"at time {time}, dB")
    made = made or (rendered(still), rendered(still).GetMTime())
    assert made == (rendered(still), rendered(still).GetMTime()), "a constant cloud is made anew"
    assert "method: none" not in moves.GetProperty("SplatChoices").GetElement(0)
