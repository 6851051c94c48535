export { decodeTable } from './decode.ts'
export { readTable, type TableLimits } from './readTable.ts'
export { TableError, type Encoding, type Reading, type Table, type TableProblem } from './types.ts'
