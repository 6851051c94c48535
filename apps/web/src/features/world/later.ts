// What is seen once something in the world is selected, or Bo shows or sounds something, or is lost.
export { default as LostNote } from './LostNote.svelte'
export { default as RobotScreen } from './RobotScreen.svelte'
export { default as TurnHandle } from './TurnHandle.svelte'
