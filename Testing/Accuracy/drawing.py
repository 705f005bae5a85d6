# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK draws of a scene, as arrays to hold against the truth. Row 0 is the lowest."""
import os
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass, vtkRenderPassCollection, vtkSequencePass, vtkShadowMapBakerPass, vtkShadowMapPass)
import pointsplatting

COUNTING_OPACITY = 0.1


def window(width, height):
    """Off screen, with or without an X server; one sample a pixel."""
    made = (vtkRenderWindow() if os.environ.get("DISPLAY")
            else pointsplatting.vtkEGLHeadlessRenderWindow())
    made.SetOffScreenRendering(1)
    made.SetMultiSamples(0)
    made.SetSize(width, height)
    return made


def depth(window, renderer):
    """Of the frame that a renderer last drew in all of a window: before the eye, infinite where there is
    nothing."""
    values = vtkFloatArray()
    width, height = window.GetSize()
    window.GetZbufferData(0, 0, width - 1, height - 1, values)
    z = vtk_to_numpy(values).reshape(height, width).astype(float)
    camera = renderer.GetActiveCamera()
    near, far = camera.GetClippingRange()
    if camera.GetParallelProjection():
        found = near + z * (far - near)
    else:
        found = near * far / (far - z * (far - near))
    return np.where(z < 1, found, np.inf)


def save(path, picture):
    image = vtkImageData()
    image.SetDimensions(picture.shape[1], picture.shape[0], 1)
    values = np.clip(np.round(picture), 0, 255).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, 3), deep=1))
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()


def copied(prop):
    made = prop.NewInstance()
    made.DeepCopy(prop)
    # VTK 9.6 copies another ambient colour than it is given.
    made.SetAmbientColor(prop.GetAmbientColor())
    return made


class Drawing:
    """One window with one mapper for each of a scene's parts."""

    def __init__(self, scene, mappers, size, peels=None, shared=None):
        """peels: of VTK's dual depth peeling, for translucent scenes; None: none. (0 does not mean
        all of them there: after the first it blends the rest unsorted.) shared: a window of many
        drawings, in which shaders are compiled once for all."""
        self.scene, self.size, self.mappers = scene, size, mappers
        self.renderer = vtkRenderer()
        if peels is not None:
            self.renderer.UseDepthPeelingOn()
            self.renderer.SetMaximumNumberOfPeels(peels)
            self.renderer.SetOcclusionRatio(0.0)
        self.actors = []
        for mapper, prop in zip(mappers, scene.properties):
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.SetProperty(copied(prop))
            self.renderer.AddActor(actor)
            self.actors.append(actor)
        self.shared = shared
        self.window = shared or window(size, size)
        self.window.AddRenderer(self.renderer)
        scene.set_view(self.renderer)
        self.milliseconds = self.processor_milliseconds = None

    def turn(self, degrees):
        """The camera, and with it a light that throws shadows."""
        self.renderer.GetActiveCamera().Azimuth(degrees)
        self.renderer.ResetCameraClippingRange(self.scene.bounds)
        if self.scene.light is not None:
            light = self.renderer.GetLights().GetItemAsObject(0)
            x, y, z = light.GetPosition()
            angle = np.arctan2(y, x) + np.radians(degrees)
            light.SetPosition(np.hypot(x, y) * np.cos(angle), np.hypot(x, y) * np.sin(angle), z)

    def add_shadow_map(self, resolution=1024):
        """VTK's own shadows, of meshes."""
        self.baker = vtkShadowMapBakerPass()
        self.baker.SetResolution(resolution)
        shadows = vtkShadowMapPass()
        shadows.SetShadowMapBakerPass(self.baker)
        passes = vtkRenderPassCollection()
        passes.AddItem(self.baker)
        passes.AddItem(shadows)
        sequence = vtkSequencePass()
        sequence.SetPasses(passes)
        camera = vtkCameraPass()
        camera.SetDelegatePass(sequence)
        self.renderer.SetPass(camera)

    def draw(self):
        """A frame with read-back, which waits until all is drawn: colours, 0 to 255."""
        if self.shared:
            self.shared.SetSize(self.size, self.size)
            for i in range(self.shared.GetRenderers().GetNumberOfItems()):
                other = self.shared.GetRenderers().GetItemAsObject(i)
                other.SetDraw(other is self.renderer)
        pixels = vtkUnsignedCharArray()
        last = self.size - 1
        start, processor = time.perf_counter(), time.process_time()
        self.window.Render()
        self.window.GetPixelData(0, 0, last, last, 0, pixels, 0)
        self.milliseconds = 1e3 * (time.perf_counter() - start)
        self.processor_milliseconds = 1e3 * (time.process_time() - processor)
        return vtk_to_numpy(pixels).reshape(self.size, self.size, 3).astype(float)

    def depth(self):
        """Of the frame last drawn: before the eye, infinite where there is nothing."""
        return depth(self.window, self.renderer)

    def drawn_with(self, lights, change):
        """A frame with other lights, and properties changed by `change`; all is put back."""
        kept = [self.renderer.GetLights().GetItemAsObject(i)
                for i in range(self.renderer.GetLights().GetNumberOfItems())]
        automatic = self.renderer.GetAutomaticLightCreation()
        background = self.renderer.GetBackground()
        properties = [actor.GetProperty() for actor in self.actors]
        self.renderer.AutomaticLightCreationOff()
        if lights:
            self.renderer.RemoveAllLights()
            for light in lights:
                self.renderer.AddLight(light)
        for actor, prop in zip(self.actors, properties):
            changed = copied(prop)
            changed.SetColor(1, 1, 1)
            change(changed)
            actor.SetProperty(changed)
        self.renderer.SetBackground(0, 0, 0)
        picture = self.draw()
        self.renderer.SetBackground(background)
        for actor, prop in zip(self.actors, properties):
            actor.SetProperty(prop)
        if lights:
            self.renderer.RemoveAllLights()
            for light in kept:
                self.renderer.AddLight(light)
        self.renderer.SetAutomaticLightCreation(automatic)
        return picture

    def normals(self):
        """Of opaque scenes, in view coordinates: read from two frames of white, dull surfaces with a
        red light along x, a green one along y and a blue one along z, and the first two reversed."""
        def change(prop):
            prop.SetAmbient(0)
            prop.SetDiffuse(1)
            prop.SetSpecular(0)

        pictures = []
        for side in (1, -1):
            lights = []
            for axis in range(3 if side > 0 else 2):
                light = vtkLight()
                light.SetLightTypeToCameraLight()
                light.SetPosition([side * float(axis == i) for i in range(3)])
                light.SetFocalPoint(0, 0, 0)
                light.SetColor([float(axis == i) for i in range(3)])
                lights.append(light)
            pictures.append(self.drawn_with(lights, change))
        normal = pictures[0] - pictures[1] * (1, 1, 0)
        length = np.linalg.norm(normal, axis=2, keepdims=True)
        return normal / np.maximum(length, 1)

    def layers(self):
        """Surfaces at each pixel, counted: all of them unlit, white and of a known low opacity, so
        that a pixel's brightness is 1 - (1 - opacity)^layers."""
        def change(prop):
            prop.SetAmbient(1)
            prop.SetDiffuse(0)
            prop.SetSpecular(0)
            prop.SetOpacity(COUNTING_OPACITY)

        smooth = [m for m in self.mappers if m.IsA("vtkPointSplatMapper") and m.GetAntiAliasing()]
        for mapper in smooth:
            mapper.AntiAliasingOff()  # its pixels at outlines are no whole numbers of layers
        white = self.drawn_with([], change)[..., 0] / 255
        for mapper in smooth:
            mapper.AntiAliasingOn()
        count = np.log(1 - np.minimum(white, 0.999)) / np.log(1 - COUNTING_OPACITY)
        return np.round(count).astype(int)

    def close(self):
        if not self.shared:
            self.window.Finalize()
        self.window.RemoveRenderer(self.renderer)
