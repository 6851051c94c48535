// What a child meets after a click, or when something has gone wrong.
export { default as Celebration } from './Celebration.svelte'
export { default as FindingPanel } from './FindingPanel.svelte'
export { default as HintPanel } from './HintPanel.svelte'
export { default as LabDialogs } from './LabDialogs.svelte'
export { default as LabMenu } from './LabMenu.svelte'
export { default as StorageNotice } from './StorageNotice.svelte'
export { default as WorldSettings } from './WorldSettings.svelte'
export { default as WorldBanner } from './WorldBanner.svelte'
