import { learningIn } from '../learning.ts'
import type { Draft } from './draft.ts'
import type { Usage } from './usage.ts'

/** What was learned by trying, at the head of the file: the best way and the whole table. */
export function learnedLines(draft: Draft, { program }: Usage): void {
  const outline = learningIn(program)
  if (!outline) return
  const { way, table } = draft.input.learned ?? {}
  const blocks = Object.values(outline.blocks)
  const line = (code: string) => draft.constants.push({ code, depth: 0, blocks })
  if (!way || !table) return void line(`# ${draft.say('python.notLearned')}`)
  line(`# ${draft.say('python.bestWay')}`)
  const stations = way.map(
    ({ station, turn, length }) => `(${station}, ${rounded(turn)}, ${rounded(length)})`,
  )
  line(`${draft.names.fresh('BEST_WAY')} = [${stations.join(', ')}]`)
  line(`# ${draft.say('python.table')}`)
  const rows = Object.entries(table).map(([from, actions]) => {
    const values = Object.entries(actions).map(([to, value]) => `${to}: ${rounded(value)}`)
    return `${from}: {${values.join(', ')}}`
  })
  line(`${draft.names.fresh('Q_TABLE')} = {${rows.join(', ')}}`)
}

const rounded = (number: number) => String(Number(number.toFixed(2)) + 0)
