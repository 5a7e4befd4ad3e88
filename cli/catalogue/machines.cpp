#include "cli/catalogue/machines.hpp"

#include <array>

namespace loadpath::cli {

namespace {

constexpr std::array known_machines{
    MachineWords{"gearbox, gear unit, gear reducer, speed reducer, gearmotor, multi-stage gearbox, transmission, "
                 "Zahnradgetriebe, Getriebemotor, Übersetzungsgetriebe, редуктор, коробка передач, мотор-редуктор",
                 "drive.train, gear.sizing, gear.pair, gear.rating, gear.planetary, gear.worm, shaft.design, "
                 "bearing.rolling, shaft.key"},
    MachineWords{"fan, blower, ventilator, centrifugal pump, Lüfter, Ventilator, Gebläse, Kreiselpumpe, вентилятор, "
                 "воздуходувка, центробежный насос",
                 "belt.v_sizing, machine.run_up, shaft.design, bearing.rolling"},
    MachineWords{"conveyor, belt conveyor, screw conveyor, bucket elevator, conveyor drive, Förderer, Förderband, "
                 "Gurtförderer, Becherwerk, Förderschnecke, конвейер, транспортёр, шнек",
                 "drive.train, chain.roller, gear.pair, machine.run_up, shaft.design"},
    MachineWords{"hoist, lift, elevator, winch, crane, crane hoist, travelling crane, Hubwerk, Aufzug, Winde, Kran, "
                 "Hebezeug, лебёдка, подъёмник, лифт, кран",
                 "dynamics.lift, drive.train, gear.worm, machine.run_up, shaft.design"},
    MachineWords{"compressor, piston compressor, piston pump, piston engine, combustion engine, engine, crankshaft, "
                 "Kompressor, Verdichter, Kolbenpumpe, Kolbenmaschine, Verbrennungsmotor, Kurbelwelle, компрессор, "
                 "поршневой насос, двигатель внутреннего сгорания, коленчатый вал",
                 "mechanism.planar, machine.flywheel, machine.motion, link.member, pin.joint, shaft.design"},
    MachineWords{"press, punch press, eccentric press, crank press, forging machine, guillotine, jaw crusher, crusher, "
                 "Presse, Exzenterpresse, Kurbelpresse, Stanze, Tafelschere, Backenbrecher, Brecher, пресс, "
                 "кривошипный пресс, ножницы, щековая дробилка, дробилка",
                 "mechanism.planar, machine.motion, machine.flywheel, link.member, pin.joint, shaft.design"},
    MachineWords{"shredder, chipper, hammer mill, ball mill, mill, rolling mill, rotary kiln, Schredder, Häcksler, "
                 "Mühle, Hammermühle, Walzwerk, Drehrohrofen, измельчитель, мельница, прокатный стан",
                 "drive.train, machine.flywheel, machine.run_up, gear.rating, belt.v_sizing, shaft.design"},
    MachineWords{"mixer, agitator, stirrer, centrifuge, Rührwerk, Mischer, Zentrifuge, мешалка, смеситель, центрифуга",
                 "shaft.design, shaft.torsion, machine.run_up, machine.disc, drive.train"},
    MachineWords{"machine tool, lathe, milling machine, grinding machine, drilling machine, saw, spindle, "
                 "Werkzeugmaschine, Drehmaschine, Fräsmaschine, Schleifmaschine, Säge, станок, шпиндель, пила",
                 "shaft.design, bearing.rolling, belt.v_sizing, gear.pair"},
    MachineWords{"axle, wheelset, wheel axle, Radachse, Radsatz, ось, колёсная пара",
                 "shaft.design, bearing.rolling, shaft.press_fit, fatigue.din743"},
    MachineWords{"differential, differential gear, Differentialgetriebe, Ausgleichsgetriebe, дифференциал",
                 "gear.planetary, gear.bevel"},
    MachineWords{"bicycle, motorcycle, Fahrrad, Motorrad, велосипед, мотоцикл", "chain.roller, chain.inverted_tooth"},
    MachineWords{"excavator, wheel loader, backhoe, tipper, Bagger, Radlader, Kipper, экскаватор, погрузчик, самосвал",
                 "mechanism.planar, link.member, pin.joint, pin.lug"},
    MachineWords{"scissor lift, lifting table, toggle clamp, gripper, hand press, Scherenhubtisch, Kniehebelspanner, "
                 "Greifer, ножничный подъёмник, захват",
                 "mechanism.planar, link.member, pin.joint"},
    MachineWords{"windscreen wiper, windshield wiper, wiper, Scheibenwischer, стеклоочиститель",
                 "mechanism.planar, motion.spherical_four_bar"},
    MachineWords{"wobble drive, wobble plate, swash plate, nutating drive, spatial linkage, Taumelscheibe, "
                 "Taumelgetriebe, Raumgetriebe, качающаяся шайба, пространственный рычажный механизм",
                 "motion.spherical_four_bar, motion.universal_joint, motion.spatial"},
    MachineWords{"packaging machine, sewing machine, loom, vibrating screen, feeder, Verpackungsmaschine, Nähmaschine, "
                 "Webstuhl, Siebmaschine, упаковочная машина, швейная машина, ткацкий станок, грохот",
                 "mechanism.planar, machine.flywheel, drive.train"},
    MachineWords{"wind turbine, turbine, generator, Windkraftanlage, Turbine, Generator, ветрогенератор, турбина, "
                 "генератор",
                 "shaft.design, gear.planetary, gear.rating, bearing.rolling, machine.disc"},
    MachineWords{"turntable, rotary table, indexing table, Drehtisch, поворотный стол",
                 "machine.run_up, dynamics.inertia, gear.worm, bearing.rolling"},
    MachineWords{"tank, boiler, silo, air receiver, reservoir, autoclave, Behälter, Kessel, Silo, Autoklav, "
                 "Druckluftbehälter, резервуар, бак, котёл, ресивер, автоклав",
                 "vessel.cylinder, vessel.end, vessel.flat_end, vessel.shell, vessel.cone"},
    MachineWords{"hydraulic cylinder, pneumatic cylinder, piston rod, Hydraulikzylinder, Kolbenstange, гидроцилиндр, "
                 "шток",
                 "vessel.thick, column.buckling, column.stepped, pin.lug, mechanism.planar"}};

}  // namespace

std::span<const MachineWords> machines() { return known_machines; }

}  // namespace loadpath::cli
