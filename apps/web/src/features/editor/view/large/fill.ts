import type * as Blockly from 'blockly/core'
import type { Program } from '@botgarten/programs'
import { toWorkspace } from '../../model/program.ts'
import { hideFar } from './far.ts'
import { showInSlices, type Slices } from './slices.ts'

/** Keys that only look around. */
const quiet = /^(Arrow|Page|Home|End|Tab|Shift|Control|Alt|Meta|Escape)/

/** A workspace that gets large programs. */
export interface Fill {
  show(program: Program): void
  /** All that is still missing, before something is changed; of one stack only, where a block of it is given. */
  finish(of?: Blockly.Block): void
  /** The workspace is emptied. */
  drop(): void
  stop(): void
}

/** Shows large programs from what is seen first; `ready` is called when the rest is there. */
function fillSlowly(workspace: Blockly.WorkspaceSvg, ready: () => void): Fill {
  const far = hideFar(workspace)
  let slices: Slices | undefined
  const finish = (of?: Blockly.Block) => slices?.finish(of)
  const host = workspace.getInjectionDiv()
  // A hand takes hold of a stack, which must be whole then, or opens a menu that may do anything.
  const touched = ({ target, button }: PointerEvent) => {
    const id = target instanceof Element && target.closest('.blocklyDraggable')?.getAttribute('data-id')
    if (id) finish((button === 0 && workspace.getBlockById(id)) || undefined)
  }
  host.addEventListener('pointerdown', touched, true)
  host.addEventListener('keydown', ({ key }) => quiet.test(key) || finish(), true)
  return {
    show(program) {
      slices = showInSlices(program, workspace, far.see, ready)
    },
    finish,
    drop: () => slices?.stop(),
    stop() {
      slices?.stop()
      far.stop()
    },
  }
}

/** Some 300 blocks. */
const isLarge = (program: Program) => JSON.stringify(program).length > 40_000

/** Shows a program on an empty workspace: at once, or a large one by `fill`, which is returned. */
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
