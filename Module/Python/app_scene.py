# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the application in the browser shows: a file's surfaces in a window that nobody sees."""
import time

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPolyData
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
)

from . import vtkIsosurfacePoints, vtkPointSplatMapper
from .reading import read

COLOURS = ((0.87, 0.78, 0.65), (0.27, 0.51, 0.71), (0.70, 0.27, 0.24), (0.55, 0.68, 0.38))
NO_ARRAY = "one colour"


def surfaces_of(data, isovalues=()):
    """Each surface of a data object, by name.

    Parameters
    ----------
    data : vtkDataObject
        A cloud, a mesh, a volume, or blocks of them.
    isovalues : sequence of float, optional
        Of volumes; by default the middle of the scalars' range.

    Returns
    -------
    list of (str, vtkPolyData)
        Points, those of isosurfaces with normals and sizes.

    Raises
    ------
    ValueError
        Where there are no points, or a volume has no scalars.
    """
    if data.IsA("vtkCompositeDataSet"):
        found = []
        walk = data.NewIterator()
        while not walk.IsDoneWithTraversal():
            found += surfaces_of(walk.GetCurrentDataObject(), isovalues)
            walk.GoToNextItem()
        return [(f"{i + 1}: {name}", points) for i, (name, points) in enumerate(found)]
    if data.IsA("vtkImageData") or data.IsA("vtkRectilinearGrid"):
        scalars = data.GetPointData().GetScalars()
        if scalars is None:
            raise ValueError("The volume has no scalars to take isosurfaces of.")
        low, high = scalars.GetRange()
        found = []
        for value in isovalues or [(low + high) / 2]:
            contour = vtkIsosurfacePoints()
            contour.SetInputData(data)
            contour.SetValue(0, value)
            contour.Update()
            found.append((f"{scalars.GetName() or 'scalars'} = {value:g}", contour.GetOutput()))
        return found
    if not isinstance(data, vtkDataSet) or data.GetNumberOfPoints() == 0:
        raise ValueError("There are no points in it.")
    if not isinstance(data, vtkPolyData):
        cloud = vtkPolyData()
        cloud.SetPoints(data.GetPoints())
        cloud.GetPointData().ShallowCopy(data.GetPointData())
        data = cloud
    return [("surface", data)]


class Scene:
    """A window with a renderer, and the surfaces of one file at a time."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0) # splats have smooth outlines of their own
        self.window.SetSize(800, 600)
        self.window.AddRenderer(self.renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        self.interactor.EnableRenderOff() # the view asks for frames
        # Headlights cast no shadows that are seen: a lamp above the camera does.
        self.lamp = vtkLight()
        self.lamp.SetLightTypeToCameraLight()
        self.lamp.SetPosition(0.6, 1.2, 1.0)
        self.lamp.SetIntensity(0.8)
        self.lamp.SwitchOff()
        self.headlight = vtkLight()
        self.headlight.SetLightTypeToHeadlight()
        self.renderer.AddLight(self.headlight)
        self.renderer.AddLight(self.lamp)
        self.actors = []
        self.frames = 0
        self._frame_time = 0.0
        self._begun = 0.0
        self.window.AddObserver("StartEvent", self._begin)
        self.window.AddObserver("EndEvent", self._end)

    def open(self, path, isovalues=()):
        """Show a file in the place of the one before.

        Parameters
        ----------
        path : path
            What :func:`pointsplatting.read` reads.
        isovalues : sequence of float, optional
            Of volumes.

        Returns
        -------
        list of str
            The surfaces' names.
        """
        surfaces = surfaces_of(read(path), isovalues)
        for actor in self.actors:
            self.renderer.RemoveActor(actor)
        self.actors = []
        for i, (_, points) in enumerate(surfaces):
            mapper = vtkPointSplatMapper()
            mapper.SetInputData(points)
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetColor(COLOURS[i % len(COLOURS)])
            self.renderer.AddActor(actor)
            self.actors.append(actor)
        self.renderer.ResetCamera()
        return [name for name, _ in surfaces]

    def arrays(self):
        """Names of the point arrays that surfaces can be coloured by.

        Returns
        -------
        list of str
            The first is for none.
        """
        names = []
        for actor in self.actors:
            data = actor.GetMapper().GetInput().GetPointData()
            names += [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())
                      if data.GetArray(i) is not None]
        own = ("Splat", "Normals")
        return [NO_ARRAY, *sorted({name for name in names if name and not name.startswith(own)})]

    def colour_by(self, name):
        """Colour all surfaces by an array, with one scale.

        Parameters
        ----------
        name : str
            Of :meth:`arrays`. `RGB` is taken for colours as they are.
        """
        chosen = [(actor.GetMapper(), actor.GetMapper().GetInput().GetPointData().GetArray(name))
                  for actor in self.actors]
        ranges = [array.GetRange() for _, array in chosen if array is not None]
        table = vtkLookupTable()
        table.SetHueRange(0.66, 0.0)
        table.Build()
        for mapper, array in chosen:
            mapper.SetScalarVisibility(array is not None)
            if array is None:
                continue
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectColorArray(name)
            if array.GetDataType() == VTK_UNSIGNED_CHAR and array.GetNumberOfComponents() > 2:
                mapper.SetColorModeToDefault()
                continue
            mapper.SetColorModeToMapScalars()
            mapper.SetLookupTable(table)
            mapper.SetScalarRange(min(low for low, _ in ranges), max(high for _, high in ranges))

    def set_opacity(self, index, opacity):
        """Make a surface translucent.

        Parameters
        ----------
        index : int
            Which one.
        opacity : float
            0 to 1.
        """
        self.actors[index].GetProperty().SetOpacity(opacity)

    def set_shadows(self, on):
        """Let a lamp over the viewer's shoulder cast soft shadows, or light as a headlight does.

        Parameters
        ----------
        on : bool
            Whether there are shadows.
        """
        self.lamp.SetSwitch(on)
        self.headlight.SetIntensity(0.35 if on else 1.0)
        for actor in self.actors:
            actor.GetMapper().SetShadows(on)

    def set_target_error(self, error):
        """Trade quality for time.

        Parameters
        ----------
        error : float
            How much the picture may differ from the best one (rms of colour).
        """
        for actor in self.actors:
            actor.GetMapper().SetTargetError(error)

    def choices(self):
        """What was chosen for the last frame, and why.

        Returns
        -------
        list of str
            A line a choice.
        """
        for actor in self.actors:
            said = actor.GetMapper().GetChoices()
            if said:
                return said.splitlines()
        return []

    def frame_time(self):
        """Seconds that the last frame took.

        Returns
        -------
        float
            0 before the first frame.
        """
        return self._frame_time

    def _begin(self, caller, event):
        self._begun = time.perf_counter()

    def _end(self, caller, event):
        self._frame_time = time.perf_counter() - self._begun
        self.frames += 1
