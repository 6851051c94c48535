import type { Json } from './types.ts'

// Networks and the world as trees of names: objects by their keys, lists of things by the things' ids.

type Path = readonly string[]
interface Named {
  readonly [name: string]: Json
}
interface WithId {
  readonly id: string
}

const isNamed = (json: Json): json is Named =>
  typeof json === 'object' && json !== null && !Array.isArray(json)
const isThing = (json: Json): json is WithId => isNamed(json) && typeof json['id'] === 'string'
const isList = (json: Json): json is readonly WithId[] => Array.isArray(json) && json.every(isThing)

/** What stands there; undefined: nothing. */
export function getIn(json: Json, [name, ...rest]: Path): Json {
  if (name === undefined) return json
  if (isList(json))
    return getIn(
      json.find(({ id }) => id === name),
      rest,
    )
  return isNamed(json) && Object.hasOwn(json, name) ? getIn(json[name], rest) : undefined
}

/** The tree with another value there, null: with none; undefined where there is no such place. */
export function setIn(json: Json, [name, ...rest]: Path, value: Json): Json {
  if (name === undefined) return value
  if (isList(json)) return setInList(json, name, rest, value)
  if (!isNamed(json)) return undefined
  const { [name]: before, ...others } = json
  if (rest.length === 0 && value === null) return others
  const after = setIn(before ?? (rest.length > 0 ? {} : null), rest, value)
  return after === undefined ? undefined : { ...json, [name]: after }
}

function setInList(list: readonly WithId[], id: string, rest: Path, value: Json): Json {
  const at = list.findIndex((one) => one.id === id)
  if (rest.length === 0 && value === null) return at < 0 ? list : list.toSpliced(at, 1)
  const after = at < 0 && rest.length > 0 ? undefined : setIn(list[at], rest, value)
  if (!isThing(after) || after.id !== id) return undefined
  return at < 0 ? [...list, after] : list.with(at, after)
}

/** These are one value: half of one and half of another is none. */
const whole = new Set([
  'pose',
  'size',
  'floor',
  'shape',
  'points',
  'layers',
  'config',
  'examples',
  'practice',
])

export const same = (a: Json, b: Json): boolean => a === b || JSON.stringify(a) === JSON.stringify(b)

/** What differs, a path each; `deep`: from this many names on a new part is set name by name. */
export function differences(
  before: Json,
  after: Json,
  deep: number,
  path: Path = [],
): readonly { readonly path: Path; readonly value: Json }[] {
  if (same(before, after)) return []
  if (after === undefined) return [{ path, value: null }]
  const isWhole = whole.has(path.at(-1) ?? '')
  if (!isWhole && isList(before) && isList(after)) {
    const ids = new Set([...before, ...after].map(({ id }) => id))
    return [...ids].flatMap((id) => differences(getIn(before, [id]), getIn(after, [id]), deep, [...path, id]))
  }
  const opened = before === undefined && path.length >= deep ? {} : before
  if (isWhole || !isNamed(opened) || !isNamed(after)) return [{ path, value: after }]
  const names = new Set([...Object.keys(opened), ...Object.keys(after)])
  return [...names].flatMap((name) => differences(opened[name], after[name], deep, [...path, name]))
}
