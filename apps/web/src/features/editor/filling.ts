import type * as Blockly from 'blockly/core'
import type { Program } from '@botgarten/programs'
import { fillSlowly, type Fill } from './large/fill.ts'
import { toWorkspace } from './program.ts'

/** Some 300 blocks. */
const isLarge = (program: Program) => JSON.stringify(program).length > 40_000

/** Shows a program on an empty paper: at once, or a large one by `fill`, which is returned. */
export function show(
  program: Program,
  workspace: Blockly.WorkspaceSvg,
  fill: Fill | undefined,
  ready: () => void,
): Fill | undefined {
  if (!isLarge(program)) return (toWorkspace(program, workspace), fill)
  const slowly = fill ?? fillSlowly(workspace, ready)
  slowly.show(program)
  return slowly
}
