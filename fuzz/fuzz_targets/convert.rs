#![no_main]

hemidisc_fuzz::target!(convert);
