#![no_main]

hemidisc_fuzz::target!(points);
