// Blocks for deeper networks, for learning by trying and for sorting: loaded before a program that uses them is opened.
import { knowCurves } from '@botgarten/learning/neural-network'
import { curves } from '@botgarten/learning/neural-network/curves'

export { blocks as learning } from './blocks.ts'
export { learningToolbox } from './toolbox.ts'

// Deeper networks need every activation.
knowCurves(curves)
