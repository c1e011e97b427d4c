/// The values that a script wrote for a table: a line of its file, the name and numbers in hex.
fn committed(file: &str, name: &str) -> std::vec::Vec<u64> {
    let line = file.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
    let words = line.unwrap_or_else(|| panic!("{name}")).split(' ');
    words.map(|word| u64::from_str_radix(word, 16).unwrap()).collect()
}

/// A table of the crate is that of the script.
fn assert_derived<T: Copy + Into<u64>>(file: &str, name: &str, table: &[T]) {
    let table: std::vec::Vec<u64> = table.iter().map(|&value| value.into()).collect();
    assert_eq!(table, committed(file, name), "{name}");
}
