/** Where a part of data lies: names from the outside in. */
export type Path = readonly string[]

/** Every part of data, the whole first. */
export function pathsIn(value: unknown, path: Path = []): Path[] {
  const below =
    typeof value === 'object' && value !== null
      ? Object.entries(value).flatMap(([name, child]) => pathsIn(child, [...path, name]))
      : []
  return [path, ...below]
}

/** A copy of the data with another value at a path. */
export function replaced(data: unknown, [name, ...rest]: Path, value: unknown): unknown {
  if (name === undefined) return value
  const copy = structuredClone(data) as { [name: string]: unknown }
  copy[name] = replaced(copy[name], rest, value)
  return copy
}
