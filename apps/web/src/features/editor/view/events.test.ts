import * as Blockly from 'blockly/core'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { listen } from './events.ts'

beforeEach(() => void vi.useFakeTimers())
afterEach(() => vi.useRealTimers())

/** Listens to a workspace that a test changes and drags. */
function listened() {
  let isDragged = false
  const workspace = Object.assign(new Blockly.Workspace(), { isDragging: () => isDragged })
  const nothing = () => {}
  const reports = {
    ...{ change: nothing, undoStep: nothing, select: nothing, copied: nothing, finding: nothing },
  }
  const emit = vi.fn()
  const stop = listen(workspace as unknown as Blockly.WorkspaceSvg, reports, emit)
  return {
    ...{ emit, stop },
    change: () => workspace.fireChangeListener(new Blockly.Events.VarCreate()),
    drag: (now: boolean) => {
      isDragged = now
    },
  }
}

test('changes within a frame are reported once', () => {
  const { emit, stop, change } = listened()
  change()
  change()
  expect(emit).not.toHaveBeenCalled()
  vi.advanceTimersByTime(20)
  expect(emit).toHaveBeenCalledOnce()
  stop()
  expect(emit).toHaveBeenCalledOnce()
})

test('a change during a drag is reported when the drag has ended', () => {
  const { emit, stop, change, drag } = listened()
  drag(true)
  change()
  vi.advanceTimersByTime(1_000)
  expect(emit).not.toHaveBeenCalled()
  drag(false)
  vi.advanceTimersByTime(20)
  expect(emit).toHaveBeenCalledOnce()
  stop()
})

test('a change that is not reported yet when the editor closes is reported then, and not again', () => {
  const { emit, stop, change } = listened()
  change()
  stop()
  expect(emit).toHaveBeenCalledOnce()
  vi.advanceTimersByTime(1_000)
  expect(emit).toHaveBeenCalledOnce()
})
