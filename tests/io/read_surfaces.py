"""Reads a .vtp file of particles by VTK and prints what is in it.

time T
points N triangles N
then a line a particle: id shape speed volume x y z   (volume and centre enclosed by its triangles)
"""

import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

reader = vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
surface = reader.GetOutput()
columns = surface.GetPointData()
points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def column(name):
    return vtk_to_numpy(columns.GetArray(name))


print("time", vtk_to_numpy(surface.GetFieldData().GetArray("TimeValue"))[0])
print("points", surface.GetNumberOfPoints(), "triangles", surface.GetNumberOfPolys())
assert numpy.allclose(numpy.linalg.norm(column("velocity"), axis=1), column("speed"), rtol=1e-5)
a, b, c = (points[corners[:, k]] for k in range(3))
outwards = numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), column("Normals")[corners[:, 0]])
assert (outwards > 0.0).all(), "a triangle turned inside out"
for one in numpy.unique(column("id")):
    own = column("id")[corners[:, 0]] == one
    inside = points[column("id") == one].mean(axis=0)  # short arms keep the digits
    p, q, r = a[own] - inside, b[own] - inside, c[own] - inside
    parts = numpy.einsum("ij,ij->i", p, numpy.cross(q, r)) / 6.0
    centre = inside + (parts[:, None] * (p + q + r) / 4.0).sum(axis=0) / parts.sum()
    first = numpy.flatnonzero(column("id") == one)[0]
    print(one, column("shape")[first], repr(float(column("speed")[first])), parts.sum(), *centre)
