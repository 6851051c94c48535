import type { Table } from './bench.ts'

const row = (cells: readonly (string | number)[]) => `| ${cells.map(String).join(' | ')} |`

/** The file of a table in `results/`. */
export function markdown(table: Table, made: { command: string; machine: string; date: string }): string {
  const { title, how, columns, rows, notes = [] } = table
  return [
    `# ${title}`,
    '',
    how,
    '',
    row(columns),
    row(columns.map(() => '---')),
    ...rows.map(row),
    '',
    ...(notes.length > 0 ? [...notes.map((note) => `- ${note}`), ''] : []),
    `${made.date} · ${made.machine}`,
    '',
    `Made by \`${made.command}\`.`,
    '',
  ].join('\n')
}

/** What people have written below a table, from its first heading on: it stays when the table is made again. */
export function writtenBelow(before: string): string {
  const at = before.indexOf('\n## ')
  return at < 0 ? '' : before.slice(at)
}
