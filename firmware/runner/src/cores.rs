//! The cores, and the board that stands for each in QEMU.

/// A core and its board.
pub struct Core {
    /// Its name in the report.
    pub name: &'static str,
    /// The triple that it is built for.
    pub target: &'static str,
    pub qemu: &'static str,
    pub machine: &'static [&'static str],
    /// `-icount shift`: an instruction takes 2^shift ns. The Arm boards read them off a timer,
    /// which wants them longer than a tick; `minstret` counts them itself.
    pub shift: u32,
    pub linker: &'static str,
    pub linker_arguments: &'static [&'static str],
    /// Whether it has no FPU, so that a float is a call.
    pub soft_float: bool,
}

const ARM: Core = Core {
    name: "",
    target: "",
    qemu: "qemu-system-arm",
    machine: &[],
    shift: 5,
    linker: "arm-none-eabi-ld",
    linker_arguments: &[],
    soft_float: true,
};

pub const CORES: [Core; 4] = [
    Core { name: "Cortex-M0", target: "thumbv6m-none-eabi", machine: &["-M", "microbit"], ..ARM },
    Core { name: "Cortex-M3", target: "thumbv7m-none-eabi", machine: &["-M", "mps2-an385"], ..ARM },
    Core {
        name: "Cortex-M4F",
        target: "thumbv7em-none-eabihf",
        machine: &["-M", "mps2-an386"],
        soft_float: false,
        ..ARM
    },
    Core {
        name: "RV32IMC",
        target: "riscv32imc-unknown-none-elf",
        qemu: "qemu-system-riscv32",
        machine: &["-M", "virt", "-bios", "none"],
        shift: 0,
        linker: "riscv64-unknown-elf-ld",
        linker_arguments: &["-melf32lriscv"],
        ..ARM
    },
];
