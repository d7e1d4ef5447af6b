struct Unguarded { Missing what; };
