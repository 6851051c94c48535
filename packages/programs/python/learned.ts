import { learningIn } from '../learning.ts'
import type { Draft } from './draft.ts'
import { constantOf, emptyTable, lessonIn } from './lesson.ts'
import type { Learned } from './types.ts'
import type { Usage } from './usage.ts'

/** What was learned by trying, at the head of the file: the best way and the whole table. */
export function learnedLines(draft: Draft, { program }: Usage): void {
  const outline = learningIn(program)
  if (!outline) return
  const { way, table } = draft.input.learned ?? {}
  const lesson = lessonIn(draft)
  const blocks = Object.values(outline.blocks)
  const line = (code: string) => draft.constants.push({ code, depth: 0, blocks })
  if (!way || !table) {
    line(`# ${draft.say(lesson ? 'python.learner.empty' : 'python.notLearned')}`)
    if (lesson) line(`${constantOf(draft, 'table')} = ${tableOf(emptyTable(lesson))}`)
    return
  }
  line(`# ${draft.say('python.bestWay')}`)
  const stations = way.map(
    ({ station, turn, length }) => `(${station}, ${rounded(turn)}, ${rounded(length)})`,
  )
  line(`${draft.names.fresh('BEST_WAY')} = [${stations.join(', ')}]`)
  line(`# ${draft.say('python.table')}`)
  line(`${constantOf(draft, 'table')} = ${tableOf(table)}`)
}

function tableOf(table: NonNullable<Learned['table']>): string {
  const rows = Object.entries(table).map(([from, actions]) => {
    const values = Object.entries(actions).map(([to, value]) => `${to}: ${rounded(value)}`)
    return `${from}: {${values.join(', ')}}`
  })
  return `{${rows.join(', ')}}`
}

const rounded = (number: number) => String(Number(number.toFixed(2)) + 0)
