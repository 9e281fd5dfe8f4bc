// The first word of DatasetEntry.values, which stands for the grid: bodies change only when it does.
export function gridOf(values: string | undefined): string {
    return (values ?? '').split(' ')[0]!;
}
