// What leads into this playground and what it opens with.
export { doorsOf, type SortingDoor } from './doors.ts'
export { openForSorting } from './open.ts'
