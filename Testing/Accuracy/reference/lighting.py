# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's Phong lighting, written down again from vtkOpenGLPolyDataMapper's shader.

VTK shades by one of three formulas: a lone headlight; directional lights; positional ones too. The
first differs in its highlight, which looks along the camera's axis and not at the point.
"""
import numpy as np

from .surfaces import unit


class Material:
    """What a vtkProperty says of Phong shading."""

    def __init__(self, prop):
        self.ambient = prop.GetAmbient() * np.array(prop.GetAmbientColor())
        self.diffuse = prop.GetDiffuse() * np.array(prop.GetDiffuseColor())
        self.specular = prop.GetSpecular() * np.array(prop.GetSpecularColor())
        self.power = prop.GetSpecularPower()
        self.opacity = prop.GetOpacity()
        self.lit = bool(prop.GetLighting())


class Light:
    """A vtkLight in view coordinates, at the time when the camera stands."""

    def __init__(self, light, camera):
        self.colour = np.array(light.GetDiffuseColor()) * light.GetIntensity()
        self.headlight = bool(light.LightTypeIsHeadlight())
        self.positional = bool(light.GetPositional())
        self.world_position = np.array(light.GetTransformedPosition())
        self.world_focal_point = np.array(light.GetTransformedFocalPoint())
        if self.headlight:
            self.world_position = camera.position
            self.world_focal_point = camera.position - camera.axes[2]
        self.position = camera.points_to_view(self.world_position)
        self.direction = unit(camera.to_view(self.world_focal_point - self.world_position))
        self.attenuation = light.GetAttenuationValues()
        self.cone, self.exponent = light.GetConeAngle(), light.GetExponent()

    def at(self, positions):
        """The direction in which it shines, and its attenuation, at view coordinates."""
        if not self.positional:
            return np.broadcast_to(self.direction, positions.shape), np.ones(len(positions))
        away = positions - self.position
        distance = np.linalg.norm(away, axis=1)
        direction = away / distance[:, None]
        constant, linear, quadratic = self.attenuation
        attenuation = 1 / (constant + linear * distance + quadratic * distance ** 2)
        if self.cone < 90:
            cosine = direction @ self.direction
            inside = cosine >= np.cos(np.radians(self.cone))
            attenuation *= np.where(inside, np.maximum(cosine, 0) ** self.exponent, 0)
        return direction, attenuation


def lights_of(renderer, camera):
    """A vtkRenderer's lights that are on; VTK's own headlight where there are none."""
    if not renderer.GetLights().GetNumberOfItems():
        renderer.CreateLight()
    renderer.UpdateLightsGeometryToFollowCamera()
    lights = renderer.GetLights()
    return [Light(lights.GetItemAsObject(i), camera) for i in range(lights.GetNumberOfItems())
            if lights.GetItemAsObject(i).GetSwitch()]


def shade(material, lights, positions, normals, factors):
    """Colours, 0 to 1, of points in view coordinates with normals of unit length towards the
    viewer; factors [lights] are the share of each light that arrives, a number or [n]."""
    if not material.lit:
        return np.broadcast_to(material.ambient + material.diffuse, positions.shape)
    diffuse = np.zeros(positions.shape)
    specular = np.zeros(positions.shape)
    alone = len(lights) == 1 and lights[0].headlight and not lights[0].positional
    for light, factor in zip(lights, factors):
        if alone:
            df = np.maximum(normals[:, 2], 0)
            sf = np.where(df > 0, df, 0) ** material.power * (df > 0)
        else:
            direction, attenuation = light.at(positions)
            cosine = np.einsum("ij,ij->i", normals, direction)
            df = np.maximum(-cosine * attenuation, 0)
            reflected = direction - 2 * cosine[:, None] * normals
            towards = np.maximum(-np.einsum("ij,ij->i", reflected, unit(positions)), 0)
            sf = (df > 0) * attenuation * towards ** material.power
        diffuse += (df * factor)[:, None] * light.colour
        specular += (sf * factor)[:, None] * light.colour
    colour = material.ambient + diffuse * material.diffuse + specular * material.specular
    return np.clip(colour, 0, 1)
