// `npm run mutants`: changes one line at a time in a copy of the tree, and asks the unit tests whether they see it.
import { readFileSync, rmSync, writeFileSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { inHouse } from '../prepare/house.mjs'
import { asScript, Trouble } from '../prepare/run.mjs'
import { copyTree } from './copy.ts'
import { reportOf, shareOf, type RoomReport, type Tried } from './report.ts'
import { rooms, type Room } from './rooms.ts'
import { filesOf, sampleOf, type Equivalent } from './sample.ts'
import { Warm } from './warm.ts'

const house = inHouse('.')
const equivalent = JSON.parse(
  readFileSync(inHouse('scripts/mutants/equivalent.json'), 'utf8'),
) as readonly Equivalent[]

async function tryRoom(
  name: string,
  warm: Warm,
  options: { count: number; seed: number; only: string },
): Promise<RoomReport> {
  const room = rooms[name]!
  const { mutants, among } = sampleOf(house, room, { ...options, equivalent })
  const own = mutants.filter(({ file }) => new RegExp(options.only).test(file))
  const files = filesOf(house, room)
  const known = equivalent.filter(({ file }) => files.includes(file)).length
  const tried: Tried[] = []
  // Mutants of one file follow each other, since their tests are warm then.
  for (const mutant of own.toSorted((a, b) => a.file.localeCompare(b.file) || a.line - b.line)) {
    const { file, text } = mutant
    if (tried.at(-1)?.mutant.file !== file) await refuseFailing(file, room, warm)
    const { kind: outcome } = await warm.ask({ file, text, ...asked(room) })
    if (outcome === 'ready') throw new Error('Vitest has started again.')
    tried.push({ mutant, outcome })
    console.log(
      `${name} ${tried.length}/${own.length} ${outcome.padEnd(8)} ${file}:${mutant.line}  ${mutant.change}`,
    )
  }
  return { name, room, among, equivalent: known, tried }
}

const asked = ({ tests, walking = [] }: Room) => ({ tests, walking })

/** Tests that fail without any fault would kill every mutant. */
async function refuseFailing(file: string, room: Room, warm: Warm): Promise<void> {
  for (let left = 1; ; left--) {
    const answer = await warm.askFirst({ file, text: readFileSync(inHouse(file), 'utf8'), ...asked(room) })
    if (answer.kind !== 'killed' && answer.kind !== 'timeout') return
    const why = `The tests of ${file} fail as it is: ${'by' in answer ? answer.by : answer.kind}`
    if (left === 0) throw new Trouble(why)
    // A machine that is busy with something else may have kept them waiting.
    console.log(why)
    warm.close()
  }
}

await asScript(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      sample: { type: 'string', default: '60' },
      seed: { type: 'string', default: '1' },
      out: { type: 'string' },
      only: { type: 'string', default: '' },
    },
  })
  const names = positionals.length > 0 ? positionals : Object.keys(rooms)
  const unknown = names.find((name) => !Object.hasOwn(rooms, name))
  if (unknown !== undefined)
    throw new Trouble(`There is no room ${unknown}. Rooms: ${Object.keys(rooms).join(', ')}.`)
  const [count, seed] = [Number(values.sample), Number(values.seed)]
  const copy = copyTree(house)
  const warm = new Warm(copy)
  const reports: RoomReport[] = []
  try {
    for (const name of names) reports.push(await tryRoom(name, warm, { count, seed, only: values.only }))
  } finally {
    warm.close()
    rmSync(copy, { recursive: true, force: true })
  }
  const report = reportOf(reports, seed)
  if (values.out === undefined) console.log(`\n${report}`)
  else writeFileSync(values.out, report)
  return reports.every((one) => shareOf(one) >= one.room.goal) ? 0 : 1
})
