import * as Blockly from 'blockly/core'
import { hiddenType } from '@botgarten/blocks'
import type { Activation } from '@botgarten/learning/neural-network'
import { grouped } from '../model/list.ts'
import { stateOfTemplate } from '../model/state.ts'

// Hidden layers as blocks, changed from the playground.

type Workspace = Blockly.WorkspaceSvg
export type LayerActivation = Exclude<Activation, 'softmax'>

/** Words of files for what a hidden layer's neurons do. */
const fieldOf: { readonly [name in LayerActivation]: string } = {
  identity: 'LINEAR',
  relu: 'RELU',
  sigmoid: 'SIGMOID',
  tanh: 'TANH',
  threshold: 'THRESHOLD',
}

/** A hidden layer before the outputs, as a block. */
export function addLayer(workspace: Workspace, network: string, neurons: number): void {
  const socket = workspace.getBlockById(network)?.getInput('INPUT_LAYER')?.connection
  if (!socket) return
  grouped(() => {
    const before = socket.targetBlock()
    const state = stateOfTemplate({
      type: hiddenType,
      fields: { NEURONS: String(neurons), ACTIVATION: 'RELU' },
    })
    const layer = Blockly.serialization.blocks.append(state, workspace, { recordUndo: true })
    socket.connect(layer.outputConnection!)
    const inner = layer.getInput('LAYER')?.connection
    if (before?.outputConnection) inner?.connect(before.outputConnection)
  })
}

/** So many neurons; with none the layer's block goes, and what stands in it takes its place. */
export function setNeurons(workspace: Workspace, layer: string, neurons: number): void {
  const block = workspace.getBlockById(layer)
  if (!block) return
  grouped(() => {
    if (neurons > 0) block.setFieldValue(String(neurons), 'NEURONS')
    else removeLayer(block)
  })
}

function removeLayer(block: Blockly.Block): void {
  const socket = block.outputConnection?.targetConnection
  const inner = block.getInput('LAYER')?.connection?.targetBlock()?.outputConnection
  inner?.disconnect()
  block.dispose(false)
  if (socket && inner) socket.connect(inner)
}

/** What becomes of the sums of a layer's neurons. */
export function setLayerActivation(workspace: Workspace, layer: string, activation: LayerActivation): void {
  grouped(() => workspace.getBlockById(layer)?.setFieldValue(fieldOf[activation], 'ACTIVATION'))
}
