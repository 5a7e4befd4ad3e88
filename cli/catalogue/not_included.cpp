#include "cli/catalogue/not_included.hpp"

#include "cli/catalogue/search.hpp"
#include "lib/calculator/record.hpp"
#include "lib/text/search.hpp"

#include <algorithm>
#include <array>

namespace loadpath::cli {

namespace {

constexpr std::array all{
    NotIncluded{"bolted joints and screw threads",
                "bolt, bolted joint, screw, screw thread, thread, stud, hex nut, washer, fastener, preload, VDI 2230, "
                "tightening torque, Schraube, Schraubenverbindung, Gewinde, Mutter, Anziehmoment, болт, винт, гайка, "
                "резьба, болтовое соединение",
                "pin.joint, shaft.set_screw"},
    NotIncluded{"power screws and ball screws",
                "power screw, lead screw, ball screw, screw jack, trapezoidal thread, Bewegungsschraube, "
                "Kugelgewindetrieb, Spindel, ходовой винт, передача винт-гайка, ШВП",
                "drive.train"},
    NotIncluded{"rivets, glued and soldered joints",
                "rivet, adhesive, glue, bonded joint, solder, brazed joint, Niet, Klebverbindung, Lötverbindung, "
                "заклёпка, клеевое соединение, пайка",
                "pin.cross, pin.en1993"},
    NotIncluded{"welds and their static strength",
                "weld, welded joint, fillet weld, butt weld, weld throat, Schweißnaht, Kehlnaht, "
                "Schweißverbindung, сварка, сварной шов, сварное соединение",
                "fatigue.history, section.built_up"},
    NotIncluded{"spring design: stress, rate and buckling",
                "spring, helical spring, compression spring, extension spring, leaf spring, disc spring, Belleville, "
                "torsion spring, EN 13906, Feder, Druckfeder, Zugfeder, Tellerfeder, Blattfeder, Schraubenfeder, "
                "пружина, рессора, тарельчатая пружина",
                "mechanism.planar, dynamics.work, shaft.held"},
    NotIncluded{"spiral bevel and hypoid gears, globoid worms",
                "hypoid gear, hypoid, spiral bevel, Zerol, globoid worm, Hypoidrad, Spiralkegelrad, Globoidschnecke, "
                "гипоидная передача, глобоидная передача",
                "gear.bevel, gear.worm"},
    NotIncluded{"cycloidal speed reducers and harmonic drives",
                "cycloidal drive, cycloidal reducer, cycloidal speed reducer, harmonic drive, strain wave gear, "
                "Zykloidgetriebe, Wellgetriebe, циклоидальный редуктор, волновая передача",
                "gear.planetary, drive.train"},
    NotIncluded{"scuffing, micropitting and the gear rating of AGMA 2001",
                "scuffing, micropitting, AGMA, AGMA 2001, Fressen, Graufleckigkeit, заедание", "gear.rating"},
    NotIncluded{"clutches and couplings",
                "clutch, coupling, friction clutch, shaft coupling, universal joint, Cardan joint, freewheel, "
                "Kupplung, Reibkupplung, Wellenkupplung, Gelenkwelle, Kreuzgelenk, Freilauf, муфта, сцепление, "
                "карданный вал",
                "dynamics.angular_momentum, machine.run_up"},
    NotIncluded{"brakes: lining, heat and wear",
                "brake, disc brake, drum brake, band brake, Bremse, Scheibenbremse, Trommelbremse, Bandbremse, тормоз",
                "machine.run_up, dynamics.work"},
    NotIncluded{"toothed belts of curvilinear profile: power rating",
                "HTD, curvilinear profile, Hochleistungszahnriemen, зубчатый ремень с полукруглым профилем",
                "belt.synchronous, belt.course"},
    NotIncluded{"conveyor and lifting chains", "leaf chain, conveyor chain, lifting chain, Hebekette, грузовая цепь",
                "chain.roller"},
    NotIncluded{"wire ropes: strength and life", "rope, wire rope, cable, Seil, Drahtseil, канат, трос",
                "dynamics.lift"},
    NotIncluded{"plain bearings with a lubricant film",
                "plain bearing, journal bearing, sleeve bearing, hydrodynamic bearing, hydrodynamic lubrication, "
                "Sommerfeld, bushing, Gleitlager, подшипник скольжения",
                "pin.joint, bearing.rolling"},
    NotIncluded{"linear guides and slideways",
                "linear guide, linear bearing, slideway, guideway, Linearführung, Führung, линейная направляющая",
                "mechanism.planar, bearing.rolling"},
    NotIncluded{"seals, gaskets and lubricating films",
                "seal, gasket, O-ring, packing, lubricant, oil film, Dichtung, уплотнение, прокладка, смазка",
                "bearing.rolling"},
    NotIncluded{"conical and polygonal hubs, clamping elements",
                "taper fit, cone fit, clamping element, shrink disc, taper lock, clamping hub, polygon shaft, "
                "Kegelsitz, Spannsatz, Spannelement, Klemmverbindung, коническое соединение, клеммовое соединение",
                "shaft.press_fit, shaft.key"},
    NotIncluded{"three-dimensional and flexible mechanisms",
                "spatial mechanism, three-dimensional mechanism, 3D mechanism, robot, manipulator, flexible multibody, "
                "compliant mechanism, räumliches Getriebe, Roboter, пространственный механизм, робот",
                "mechanism.planar, motion.spherical_four_bar"},
    NotIncluded{"finite elements",
                "finite element, FEM, FEA, finite element analysis, Finite Elemente, "
                "метод конечных элементов, МКЭ",
                "shaft.design, link.member"},
    NotIncluded{"beams and girders with transverse loads, frames",
                "beam, girder, cantilever, continuous beam, frame analysis, Balken, Träger, Biegeträger, Rahmen, "
                "балка, рама",
                "link.member, shaft.design, column.effective_length"},
    NotIncluded{"trusses as structures; a statically determinate one is a mechanism of mobility 0",
                "truss, lattice girder, Fachwerk, ферма", "mechanism.planar, column.buckling"},
    NotIncluded{"plates, flanges and nozzles",
                "plate, flat plate, flange, nozzle, manhole, tube sheet, Platte, Flansch, Stutzen, "
                "пластина, фланец, патрубок",
                "vessel.cylinder, vessel.end, vessel.shell"},
    NotIncluded{"cones, ends and reinforcing rings under external pressure",
                "cone under external pressure, head under external pressure, stiffening ring, Versteifungsring",
                "vessel.external"},
    NotIncluded{"plate buckling and lateral torsional buckling",
                "plate buckling, local buckling, lateral torsional buckling, Beulen, Biegedrillknicken, Kippen, "
                "местная устойчивость",
                "column.buckling, link.member"},
    NotIncluded{"fracture mechanics and crack growth",
                "fracture mechanics, crack growth, Paris law, stress intensity factor, Bruchmechanik, Rissfortschritt, "
                "механика разрушения, рост трещины",
                "fatigue.history, fatigue.life"},
    NotIncluded{"low-cycle fatigue by strains",
                "low cycle fatigue, strain life, Coffin-Manson, Manson-Coffin, Neuber, Dehnungswöhlerlinie, "
                "Kurzzeitfestigkeit, малоцикловая усталость",
                "fatigue.life, fatigue.history"},
    NotIncluded{"creep and corrosion", "creep, corrosion, Kriechen, Korrosion, ползучесть, коррозия",
                "fatigue.endurance"},
    NotIncluded{"heat transfer and thermal stress",
                "heat transfer, thermal stress, thermal expansion, Wärmeübertragung, Wärmespannung, теплообмен, "
                "температурные напряжения",
                "shaft.press_fit"},
    NotIncluded{"pipe flow, pumps and hydraulic drives",
                "pipe flow, pressure drop, pump, hydraulics, pneumatics, Pumpe, Hydraulik, Rohrströmung, насос, "
                "гидравлика, гидропривод",
                "mechanism.planar, vessel.cylinder"},
    NotIncluded{"vibration of machines and foundations, balancing of rotors",
                "vibration isolation, forced vibration, rotor balancing, modal analysis, Schwingung, Auswuchten, "
                "колебания, балансировка ротора",
                "shaft.design, mechanism.planar, machine.flywheel"},
    NotIncluded{"limits and fits of ISO 286", "ISO 286, limits and fits, tolerance grade, Passung, допуски и посадки",
                "shaft.press_fit, mechanism.planar"},
    NotIncluded{"electric motors: selection and heating",
                "motor selection, electric motor, servo motor, Motorauswahl, Elektromotor, выбор двигателя, "
                "электродвигатель",
                "machine.motion, machine.run_up, machine.flywheel, drive.train"},
    NotIncluded{"concrete and timber structures", "concrete, timber, wood, Beton, Holz, бетон, древесина",
                "column.buckling, section.built_up"}};

}  // namespace

std::span<const NotIncluded> not_included() { return all; }

std::vector<const NotIncluded*> not_included(std::string_view text, bool exactly) {
  const auto searched = subject_of(search_words(text));
  std::vector<const NotIncluded*> found;
  for (const NotIncluded& one : all) {
    const auto names = listed_keys(one.words);
    const bool is_named = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      const auto words = search_words(name);
      return exactly ? match(searched, words) == Match::whole : holds_words(searched, words);
    });
    if (is_named) found.push_back(&one);
  }
  return found;
}

}  // namespace loadpath::cli
