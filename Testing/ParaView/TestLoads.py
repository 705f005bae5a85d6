# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin is loaded, and all that it brings is there."""
from paraview import servermanager, simple

shown = servermanager.ProxyManager().NewProxy("representations", "GeometryRepresentation")
assert shown.GetProperty("SplatChoices"), "representations have no properties of splats"
for name in (
    "IsosurfacePoints", "ParticleSurfacePoints", "PointSplatEstimation", "PointSplatGrouping",
    "PointSplatProjection",
):  # fmt: skip
    proxy = getattr(simple, name)
    assert proxy.__doc__ or name, name
    made = servermanager.ProxyManager().NewProxy("filters", name)
    assert made.GetDocumentation().GetLongHelp() or made.GetDocumentation().GetDescription()
plugins = simple.servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
information = plugins.GetLocalInformation()
loaded = [
    information.GetPluginName(i)
    for i in range(information.GetNumberOfPlugins())
    if information.GetPluginLoaded(i)
]
assert "PointSplatting" in loaded, loaded
