# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scan says of its surface, as contact.c does: python3 contact.py scan.csv [um]"""
import ctypes
import itertools
import os
import sys
from ctypes import byref, c_char_p, c_double, c_int, c_size_t, c_void_p


class Status(ctypes.Structure):
    _fields_ = [("code", c_int), ("message", ctypes.c_char * 1024)]


class ScanOptions(ctypes.Structure):
    _fields_ = [("x_unit", c_char_p), ("z_unit", c_char_p)]


class RunOptions(ctypes.Structure):
    _fields_ = [("material", c_void_p), ("counterface", c_void_p), ("hardness_Pa", c_double), ("load", c_int)]


class Point(ctypes.Structure):
    _fields_ = [("exists", c_int), ("valid", c_int)] + [(name, c_double) for name in (
        "load", "pressure_Pa", "area_ratio", "separation_m", "ecr_ohm_m2", "tcr_K_m2_per_W")]


class PowerLaw(ctypes.Structure):
    _fields_ = [("law", c_int), ("alpha", c_double), ("gamma", c_double), ("gamma_error", c_double)]


library = ctypes.CDLL("libroughcontact.so.1")
library.roughcontact_surface_roughness.restype = ctypes.POINTER(c_double)  # rq_m comes first
library.roughcontact_surface_power_law.restype = ctypes.POINTER(PowerLaw)
library.roughcontact_curve_point.restype = ctypes.POINTER(Point)
library.roughcontact_curve_point.argtypes = [c_void_p, c_size_t]
for name in ("scan_warning", "surface_note"):
    getattr(library, "roughcontact_" + name).restype = c_char_p
    getattr(library, "roughcontact_" + name).argtypes = [c_void_p, c_size_t]
for name in ("surface_roughness", "surface_power_law", "scan_free", "surface_free", "material_free", "curve_free"):
    getattr(library, "roughcontact_" + name).argtypes = [c_void_p]


def make(function, *arguments):
    """The handle that a function of the library makes, or an exception with its message."""
    handle, status = c_void_p(), Status()
    if getattr(library, "roughcontact_" + function)(byref(handle), *arguments, byref(status)) != 0:
        sys.exit(status.message.decode())
    return handle


units, how = ScanOptions(), RunOptions()
library.roughcontact_scan_options_init(byref(units))
library.roughcontact_run_options_init(byref(how))
units.x_unit = units.z_unit = os.fsencode(sys.argv[2]) if len(sys.argv) > 2 else None  # where the file names none
loads = (c_double * 5)(1e-6, 1e-5, 1e-4, 1e-3, 1e-2)  # P/(A_n E')

scan = make("scan_read_file", os.fsencode(sys.argv[1]), byref(units))
surface = make("surface_make", scan, None)
how.material = make("material_new", b"tin")
curve = make("run", surface, b"strip-plastic", loads, c_size_t(len(loads)), byref(how))

for said, handle in ((library.roughcontact_scan_warning, scan), (library.roughcontact_surface_note, surface)):
    for i in itertools.takewhile(lambda i: said(handle, i), itertools.count()):
        print(said(handle, i).decode(), file=sys.stderr)

law = library.roughcontact_surface_power_law(surface)[0]
print("Rq %.6g um, gamma %.4g +- %.2g"
      % (library.roughcontact_surface_roughness(surface)[0] * 1e6, law.gamma, law.gamma_error))
print("%-12s %-12s %-12s %s" % ("P/A_n (Pa)", "A/A_n", "ECR (ohm m2)", "TCR (K m2/W)"))
for i in range(len(loads)):
    point = library.roughcontact_curve_point(curve, i)[0]
    print("%-12.5g %-12.5g %-12.5g %.5g%s" % (point.pressure_Pa, point.area_ratio, point.ecr_ohm_m2,
                                              point.tcr_K_m2_per_W, "" if point.valid else "  beyond the model's range"))

for kind, handle in (("curve", curve), ("material", how.material), ("surface", surface), ("scan", scan)):
    getattr(library, "roughcontact_" + kind + "_free")(handle)
