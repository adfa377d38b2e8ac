import { ColorManagement } from 'three';

// Colours are those of the screen throughout. To be imported before any colour is made.
ColorManagement.enabled = false;
