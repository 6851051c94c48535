import { content } from '@botgarten/content/files'
import { parseScene, writeScene } from '@botgarten/programs'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { drawWay } from './drawn.ts'
import type { MapFile } from './types.ts'
import { wayFault } from './way.ts'

/** A walk over roads of the map, led by numbers; no station comes twice. */
function walkOn({ map }: MapFile, choices: readonly number[]): readonly number[] {
  const way = [choices[0]! % map.actions.length]
  for (const choice of choices) {
    const open = map.actions[way.at(-1)!]!.map(({ to }) => to).filter((to) => !way.includes(to))
    if (open.length === 0) break
    way.push(open[choice % open.length]!)
  }
  return way
}

test.each(content.maps)('every way on the map %s is a scene that can be saved and read again', (id) => {
  const map = content.mapFile(id)!
  fc.assert(
    fc.property(fc.array(fc.nat(), { minLength: 2, maxLength: 400 }), (choices) => {
      const way = walkOn(map, choices)
      if (way.length < 2 || wayFault(map, way) !== null) return
      const { scene } = drawWay(map, way)
      expect(parseScene(writeScene(scene, {})).lines).toEqual(scene.lines)
    }),
    { numRuns: 30 },
  )
})

test('a way of one station, where start and goal are the same, has no fault', () => {
  expect(wayFault(content.mapFile('railway')!, [3])).toBeNull()
})
