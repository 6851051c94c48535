import { readFileSync } from 'node:fs'
import type { Given } from '@botgarten/experiments'
import { readMap } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import { content } from '../files.ts'
import { cardDocument } from '../index.ts'
import type { QuestionRun } from '../schema/questionTypes.ts'
import type { ThingSet } from '../schema/thingTypes.ts'
import { columnsOf, onPlane, rawOf } from '../things/index.ts'

export const setNamed = (id: string) => content.sets.find((set) => set.id === id)!

export function thingsOf(set: ThingSet, features: readonly string[]): Given {
  const columns = columnsOf(set, features)
  const rows = set.things.map(
    (thing) => [thing.id, columns.map((column) => onPlane(rawOf(set, thing, column), column))] as const,
  )
  return { kind: 'things', things: new Map(rows) }
}

function cageGiven(id: string): Given {
  const { cage } = content.cages.find((one) => one.cage.id === id)!
  return { kind: 'cage', cage, map: readMap(readFileSync(content.mapOfCage(id), 'utf8')).map! }
}

/** What is needed to find out what a run ends with. */
export function givenFor(run: QuestionRun): Given {
  if (run.observe === 'group') return thingsOf(setNamed(run.set), run.features)
  if (run.observe === 'cage') return cageGiven(run.cage)
  const { card, world } = content.card(run.card)!
  const program = content.program(run.card, run.file)!
  const document = cardDocument(world, card, program, 'start' in run ? run.start : 0)
  if (run.observe !== 'way') return { kind: 'lab', document, floor: content.floorOf(document.world) }
  const { map } = learningIn(document.programs[world.robots[0]!.program]!)!
  return { kind: 'learning', document, map: content.mapFile(map)! }
}
