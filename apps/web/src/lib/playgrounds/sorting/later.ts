export { doorsOf, type SortingDoor } from './doors.ts'
