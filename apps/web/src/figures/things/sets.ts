import { readThings, type ThingSet } from '@botgarten/materials/things'

const files = import.meta.glob<unknown>('../../../../../content/things/*/things.json', {
  import: 'default',
  eager: true,
})
const pictures = import.meta.glob<string>('../../../../../content/things/*/*.svg', {
  import: 'default',
  query: '?url',
  eager: true,
})

const order = ['vessels', 'leaves', 'buttons']

/** Every set of things of the content. */
export const sets: readonly ThingSet[] = Object.values(files)
  .map(readThings)
  .sort((a, b) => order.indexOf(a.id) - order.indexOf(b.id))

export const setOf = (id: string): ThingSet => sets.find((set) => set.id === id) ?? sets[0]!

/** Address of a thing's picture. */
export const pictureOf = (set: string, thing: string): string =>
  Object.entries(pictures).find(([path]) => path.endsWith(`/${set}/${thing}.svg`))![1]
