import type * as Blockly from 'blockly/core'
import type { Program } from '@botgarten/programs'
import type { Fill } from './large/fill.ts'
import { toWorkspace } from './program.ts'

let large: typeof import('./large/later.ts') | undefined

/** Some 300 blocks. */
const isLarge = (program: Program) => JSON.stringify(program).length > 40_000

/** Brings what a large program needs; resolves at once for all others. */
export async function bringLarge(program: Program): Promise<void> {
  if (isLarge(program)) large ??= await import('./large/later.ts')
}

/** Shows a program on an empty paper: at once, or a large one by `fill`, which is returned. */
export function show(
  program: Program,
  workspace: Blockly.WorkspaceSvg,
  fill: Fill | undefined,
  ready: () => void,
): Fill | undefined {
  if (!large || !isLarge(program)) return (toWorkspace(program, workspace), fill)
  const slowly = fill ?? large.fillSlowly(workspace, ready)
  slowly.show(program)
  return slowly
}
