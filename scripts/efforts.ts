// Makes the ready-made brains of all courses again and writes what that costs beside them: `npm run efforts`, after a course or
// one of its brains has changed. The contract test says when it is due; seconds of the processor are those of this machine.
import { readFileSync, writeFileSync } from 'node:fs'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { effortOf } from '@botgarten/content/answers'
import { content } from '@botgarten/content/files'
import { laneKinds } from '@botgarten/experiments/brain-race'
import { format } from 'prettier'

addBlocks(learning)
const clock = () => process.cpuUsage().user / 1e6
const tenths = (seconds: number) => Math.max(0.1, Math.round(seconds * 10) / 10)

for (const course of content.courses) {
  const world = content.world(course.world)!
  const ground = { course, world, floor: content.floorOf(world) }
  const path = content.path('courses', course.id, 'course.json')
  const file = JSON.parse(readFileSync(path, 'utf8')) as { racers: { [kind: string]: object } }
  for (const kind of laneKinds) {
    const racer = content.racer(course.id, kind)
    if (!racer) continue
    // The first making is slower: nothing is compiled yet.
    effortOf(ground, kind, racer, clock)
    const { computer, ...effort } = effortOf(ground, kind, racer, clock)
    const all = { ...effort, ...(computer !== undefined && { computer: tenths(computer) }) }
    const { effort: _, ...at } = file.racers[kind] as { effort?: object }
    file.racers[kind] = Object.keys(all).length > 0 ? { ...at, effort: all } : at
  }
  writeFileSync(path, await format(JSON.stringify(file), { parser: 'json', printWidth: 110 }))
}
