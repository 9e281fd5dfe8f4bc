// Of the words that a dataset's values are told from others by (DatasetEntry.values), that of the grid: bodies change with it alone.
export function gridOf(values: string | undefined): string {
    return (values ?? '').split(' ')[0]!;
}
