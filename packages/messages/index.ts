export { fill, formsOf, type Facts, type Message, type Variants } from './message.ts'
export { writeNumber } from './numbers.ts'
export { flat, type Table, type Tree } from './table.ts'
