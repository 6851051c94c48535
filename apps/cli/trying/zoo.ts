import { content } from '@botgarten/content/files'
import { countOf, rowsOf } from '@botgarten/experiments/cages'
import { CallError } from '../errors.ts'
import { wholeNumberIn } from '../options.ts'
import { message } from '../words.ts'

/** What many robots do in a cage of the zoo of sensors: the line that its `rows.json` holds. */
export function zooRows(
  id: string,
  more: readonly string[],
  { seeds, json }: { readonly seeds?: string; readonly json?: boolean },
): string {
  const cage = content.senseCage(id)
  if (!cage || more.length > 0)
    throw new CallError('call.zoo', { cage: id, cages: content.senseIds.join(', ') })
  const world = content.world(cage.world)!
  const [robot] = world.robots
  const worlds = cage.starts.map((pose) => ({ ...world, robots: [{ ...robot!, pose }] }))
  const rows = rowsOf(
    cage,
    { worlds, floor: content.floorOf(world) },
    wholeNumberIn('seeds', seeds, 20, 1, 1000),
  )
  if (json) return JSON.stringify(rows)
  const mended = rows.bos.filter((bo) => bo.mended !== null).length
  return message('trying.zoo', { of: rows.bos.length, count: countOf(rows.bos), mended })
}
