/** The three names that take the fewest letters put in, left out or replaced; a name that holds the word comes first. */
export const nearest = (word: string, names: readonly string[]): readonly string[] =>
  names
    .map((name) => ({ name, away: name.includes(word) ? 0 : distance(word, name) }))
    .sort((a, b) => a.away - b.away || (a.name < b.name ? -1 : 1))
    .slice(0, 3)
    .map(({ name }) => name)

/** Levenshtein's distance, a row of the table at a time. */
export function distance(from: string, to: string): number {
  let row = [...Array(to.length + 1).keys()]
  for (const [index, letter] of [...from].entries()) {
    const next = [index + 1]
    for (const [column, other] of [...to].entries())
      next.push(Math.min(next[column]! + 1, row[column + 1]! + 1, row[column]! + (letter === other ? 0 : 1)))
    row = next
  }
  return row.at(-1)!
}
