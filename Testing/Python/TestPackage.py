# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package pointsplatting as a user finds it: import, classes, PrintSelf."""
import unittest

import pointsplatting
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkFiltersCore import vtkAppendPolyData  # beside VTK's own modules

CLASSES = (
    "vtkEGLHeadlessRenderWindow",
    "vtkIsosurfacePoints",
    "vtkPointSplatEstimation",
    "vtkPointSplatMapper",
    "vtkPointSplatPass",
    "vtkPointSplatPlainScene",
    "vtkPointSplatShadowPass",
)
ABSTRACT = ("vtkPointSplatBlockMapper",)


def classes_of(module):
    return {
        name: value
        for name, value in vars(module).items()
        if name.startswith("vtk") and isinstance(value, type) and issubclass(value, vtkObject)
    }


class TestPackage(unittest.TestCase):
    def test_names(self):
        for name in CLASSES:
            self.assertTrue(hasattr(pointsplatting, name), name)

    def test_every_wrapped_class_is_at_the_top_level(self):
        for module in (
            pointsplatting.vtkFiltersPointSplatting,
            pointsplatting.vtkRenderingPointSplatting,
            getattr(pointsplatting, "vtkIOPointSplatting", pointsplatting.vtkFiltersPointSplatting),
        ):
            for name, value in classes_of(module).items():
                self.assertIs(getattr(pointsplatting, name), value)

    def test_print_self(self):
        for name, kind in classes_of(pointsplatting).items():
            if name in ABSTRACT:
                continue
            with self.subTest(name):
                instance = kind()
                text = str(instance)
                self.assertTrue(text.startswith(name), text)
                self.assertTrue(instance.IsA(name))
                self.assertEqual(instance.NewInstance().GetClassName(), name)

    def test_vtk_classes_connect(self):
        estimation = pointsplatting.vtkPointSplatEstimation()
        append = vtkAppendPolyData()
        append.AddInputConnection(estimation.GetOutputPort())
        self.assertEqual(append.GetNumberOfInputConnections(0), 1)

    def test_version(self):
        self.assertRegex(pointsplatting.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
