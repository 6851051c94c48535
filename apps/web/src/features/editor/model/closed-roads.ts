import type * as Blockly from 'blockly/core'
import type { Template } from '@botgarten/blocks'
import { isBotBlock } from './bot-block.ts'
import { addLine, grouped, linesOf, plugIn, removeLine } from './list.ts'

type Roads = readonly (readonly [from: number, to: number])[]

const list: Template = {
  type: 'rl_obstacles_easy_list',
  mutation: { attrs: { items: '0', list_type: 'Obstacle' } },
}

const barrier = (from: number, to: number): Template => ({
  type: 'ai_q_barrier_mountain',
  fields: { FROM: String(from), TO: String(to) },
})

/** Makes these the closed roads of a map block, in one step: rows that say something else go, new ones come. */
export function setClosed(workspace: Blockly.Workspace, mapId: string, roads: Roads): void {
  const map = workspace.getBlockById(mapId)
  if (!isBotBlock(map)) return
  grouped(() => {
    const rows = map.getInputTargetBlock('OBSTACLE') ?? plugIn(map, 'OBSTACLE', list)
    if (!isBotBlock(rows)) return
    const wanted = new Set(roads.map(nameOf))
    for (const line of linesOf(rows).toReversed()) {
      const row = rows.getInputTargetBlock(line)
      const name = row ? `${row.getFieldValue('FROM')}-${row.getFieldValue('TO')}` : ''
      // What stands there twice is kept once.
      if (!wanted.delete(name)) removeLine(rows, line)
    }
    for (const road of roads) if (wanted.has(nameOf(road))) addLine(rows, barrier(...road))
  })
}

const nameOf = ([from, to]: readonly [number, number]) => `${from}-${to}`
