export { readTable, type TableLimits } from './readTable.ts'
export { TableError, type Table, type TableProblem } from './types.ts'
